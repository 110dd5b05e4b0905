import pytest

from app.programs.sketches.speakers import without_doings


@pytest.mark.parametrize(
    ("said", "meant"),
    [
        (
            "Put the plums in the crate. The eggs are going in my basket and I'll see to that.",
            "Put the plums in the crate.",
        ),
        ("Put the cup on the tray and I'll deal with it later.", "Put the cup on the tray."),
        (
            "Hang the drum on the hook, then we'll start from the top.",
            "Hang the drum on the hook.",
        ),
        ("Close the hutch before the dog gets out of bed.", "Close the hutch before the dog gets out of bed."),
        ("Close the hutch before the dog jumps in.", "Close the hutch."),
        ("shut the tin before it rains", "shut the tin"),
        (
            "Shut all of them except the chest, that still has to dry.",
            "Shut all of them except the chest.",
        ),
        (
            "Put the nails in the box, but the saw's mine, so hands off.",
            "Put the nails in the box. Leave the saw alone.",
        ),
        ("Open the box before you put the cup in it.", "Open the box before you put the cup in it."),
        ("put the cup in the box, then I'd like the fork in the box", "put the cup in the box, then I'd like the fork in the box"),
    ],
)  # fmt: skip
def test_what_others_do_and_why_is_no_order(said, meant):
    assert without_doings(said) == meant
