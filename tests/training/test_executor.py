from app.training.executor import outcome

NAMES = ("cup", "plate", "box")


def test_the_last_place_counts() -> None:
    body = "    grab_and_putin('cup', 'box')\n    grab_and_putin('cup', 'plate')\n"
    assert outcome(body, NAMES).places == {"cup": "plate"}


def test_a_verb_that_names_the_place_first_is_understood() -> None:
    assert outcome("    fill('box', 'cup')\n", NAMES, {"fill": True}).places == {"cup": "box"}


def test_what_is_not_there_is_a_fault() -> None:
    done = outcome("    grab_and_putin('lamp', 'box')\n", NAMES)
    assert done.faults
    assert not done.places


def test_nothing_goes_into_what_it_carries() -> None:
    body = "    grab_and_putin('cup', 'box')\n    grab_and_putin('box', 'cup')\n"
    assert outcome(body, NAMES).faults == ["box cannot go into cup"]
    assert outcome("    grab_and_putin('cup', 'cup')\n", NAMES).faults


def test_other_verbs_are_deeds_in_order() -> None:
    body = "    open('box')\n    grab_and_putin('cup', 'box')\n    close('box')\n"
    assert outcome(body, NAMES).deeds == [("open", "box"), ("close", "box")]


def test_comments_and_pass_do_nothing() -> None:
    done = outcome("    # there is no lamp\n    pass\n", NAMES)
    assert (done.places, done.deeds, done.faults) == ({}, [], [])


def test_text_that_is_no_program_is_a_fault() -> None:
    assert outcome("    put the cup (in\n", NAMES).faults
    assert outcome("    cup\x00\n", NAMES).faults
