"""What is said instead where a thing is absent or nothing can be done."""

from app.programs.home_answers import nearest_things, not_to_be_done


def _judge(text, things):
    del text
    return [0.8 if name == "pillow" else 0.1 for (name,) in things]


def test_what_is_spelt_alike_is_named_first():
    assert nearest_things("boook", ["book", "pillow"], _judge) == ["book"]


def test_else_what_means_the_same():
    assert nearest_things("cushion", ["book", "pillow"], _judge) == ["pillow"]


def test_nothing_is_named_that_is_unlike():
    assert nearest_things("violin", ["book", "mug"], _judge) == []


def test_no_example_speaks_of_what_is_not_there():
    assert "such as" not in not_to_be_done(())
