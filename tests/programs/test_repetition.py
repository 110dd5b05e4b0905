import pytest

from app.programs.repetition import before_repetition

ONE = "    find('cup')\n"
OTHER = "    grab('cup')\n"
ASSERTION = "    assert('close' to 'cup')\n        else: find('cup')\n"


def test_what_is_said_twice_may_be_meant():
    assert before_repetition((ONE + OTHER) * 2) is None
    assert before_repetition(ONE * 2) is None


@pytest.mark.parametrize("start", ["", "    # 1: begin\n    open('fridge')\n"])
@pytest.mark.parametrize("round_", [ONE, ONE + OTHER, ONE + OTHER + "    close('fridge')\n"])
def test_the_third_round_is_a_loop_of_which_the_first_stays(start, round_):
    assert before_repetition(start + round_ * 3) == start + round_


def test_comments_that_number_the_rounds_hide_nothing():
    text = "".join(f"    # {number}: again\n{ONE}{OTHER}" for number in (1, 2, 3))
    assert before_repetition(text) == f"    # 1: again\n{ONE}{OTHER}"


def test_no_assertion_is_left_without_its_recovery():
    text = "        else: find('cup')\n" + (OTHER + ASSERTION) * 3
    kept = before_repetition(text)
    assert kept is not None
    assert not kept.rstrip().endswith("assert('close' to 'cup')")


def test_a_line_that_is_still_being_written_does_not_count():
    assert before_repetition(ONE * 2 + ONE.rstrip("\n")) is None
