import pytest

from app.programs.sketches.asides import without_thoughts


@pytest.mark.parametrize(
    ("said", "meant"),
    [
        (
            "The stapler... I was going to say the drawer, but it's stuck, so put it on the tray instead.",
            "The stapler... put it on the tray.",
        ),
        (
            "I was thinking the tin, but that's far too small, so pop the buttons in the jar.",
            "pop the buttons in the jar.",
        ),
        ("slide the crate over to the door", "slide the crate to the door"),
        (
            "so pack it all in the trunk except the kite",
            "so pack everything in the trunk except the kite",
        ),
        ("chuck the whole lot into the bin", "chuck everything into the bin"),
        (
            "Shut all the drawers. I haven't finished with the top one.",
            "Shut all the drawers. Leave the top one alone.",
        ),
        (
            "Close every box but the blue one. I'm not done with that one, or with the trunk.",
            "Close every box but the blue one. Leave the trunk alone.",
        ),
        ("Someone's left the hen house wide open. Shut it quickly.", "Shut the hen house quickly."),
        ("Open the chest, then the case.", "Open the chest and then open the case."),
        ("open the place where we keep the bread", "open the thing where we keep the bread"),
        (
            "What do we dig with? Right. Wheelbarrow, please.",
            "put the thing we dig with on the wheelbarrow, please.",
        ),
        (
            "What would you stir the paint with? Into the bucket please.",
            "put the thing you stir the paint with into the bucket please.",
        ),
    ],
)
def test_what_is_said_besides_is_put_aside(said, meant):
    assert without_thoughts(said) == meant


@pytest.mark.parametrize(
    "said",
    [
        "Put the cup on the tray.",
        "What can I do? Put the cup on the tray.",
        "We left the box open. Put the cup in it.",
        "gather up the veg and dump it all in the pot",
        "Hand the key over to the porter.",
        "I'm still hungry, so put the bun on the plate.",
    ],
)
def test_what_is_said_plainly_stays(said):
    assert without_thoughts(said) == said
