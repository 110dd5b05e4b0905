import pytest

from app.domain.scene import SceneObject
from app.programs.sketches.things import read_things
from app.programs.sketches.watering import watered

THINGS = read_things(
    SceneObject(name=name)
    for name in ("watering can", "rose", "fern", "mint plant", "water jug", "kettle", "door")
)


@pytest.mark.parametrize(
    ("said", "told"),
    [
        ("give the rose a drink from the water jug", "pour the water jug on the rose"),
        (
            "Close the door and then give the fern a good soak with the watering can.",
            "Close the door and then pour the watering can on the fern.",
        ),
        (
            "All the plants look thirsty, so take the watering can and give each of them a splash.",
            "pour the watering can on all the plants.",
        ),
        (
            "My mint is drooping. Grab the water jug and pour some on it, and spare the fern.",
            "pour the water jug on the mint, and spare the fern.",
        ),
        ("water the rose from the kettle, please", "pour the kettle on the rose, please"),
        ("pop round all the plants with the water jug", "pour the water jug on all the plants"),
        ("The rose needs watering. Use the kettle.", "pour the kettle on the rose."),
        ("pour some water in each of the cups", "pour the water in all the cups"),
        ("Give my fern a bit of a splash.", "pour the watering can on my fern."),
    ],
)
def test_who_gets_a_drink_has_the_vessel_poured_on_it(said, told):
    assert watered(said, THINGS) == told


@pytest.mark.parametrize(
    "said",
    [
        "give me the water jug",
        "I need a drink of water",
        "put the rose in the water jug",
        "Take the kettle and give it a rinse.",
        "I'll water the rose myself.",
        "what you water the rose with goes by the door",
    ],
)
def test_nothing_else_is_watered(said):
    assert watered(said, THINGS) == said
