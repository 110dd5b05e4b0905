import json

from app.programs.knowledge.uses import FILE, phrases, uses


def test_a_thing_is_told_by_what_it_is_for():
    assert "takes the cap off a beer" in uses("bottle opener")
    assert uses("corkscrew")[0] == "gets the cork out of a bottle"


def test_a_thing_of_a_longer_name_is_for_what_its_kind_is_for():
    assert uses("grandmother's corkscrew") == uses("corkscrew")
    assert uses("corkscrew_2") == uses("corkscrew")


def test_a_name_written_in_two_words_finds_what_is_written_in_one():
    assert uses("cork screw") == uses("corkscrew")


def test_of_what_nobody_knows_nothing_is_told():
    assert uses("xylem gauge") == ()


def test_every_phrase_stands_once_and_is_no_name():
    assert len(phrases()) == len(set(phrases())) > 300
    assert all(each and each == each.strip() for each in phrases())


def test_every_noun_of_the_file_has_uses():
    for noun in json.loads(FILE.read_text(encoding="utf-8")):
        assert uses(noun), noun
