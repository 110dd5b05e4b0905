import pytest

from app.programs.sketch_rephrasing import rephrased


@pytest.mark.parametrize(
    ("said", "plain"),
    [
        (
            "put it in the left basket... I mean, the rattan basket, please",
            "put it in the rattan basket, please",
        ),
        ("these go in the warm wash, that is, the white hamper", "these go in the white hamper"),
        ("give the big case a good shove", "push the big case"),
        ("put the green fruit, and only fruit, in the bowl", "put the green fruit in the bowl"),
        (
            "There are three tomatoes in a row: the middle one goes in the bowl.",
            "the middle tomato goes in the bowl.",
        ),
        (
            "Of my two ties, the silk one goes in the box. The other needs washing.",
            "the silk tie goes in the box. the other tie needs washing.",
        ),
    ],
)
def test_what_is_said_in_a_roundabout_way_is_read_plainly(said, plain):
    assert rephrased(said) == plain


@pytest.mark.parametrize(
    "said",
    [
        "put the red block and the blue one in the box",
        "there are two cups; put both in the box",
        "put the ball in the box, not the bowl",
        "give the knife to me",
        "",
    ],
)
def test_what_is_plain_stays_as_it_is(said):
    assert rephrased(said) == said
