import json

import pytest

from app.domain.scene import Scene
from app.worlds import worlds

ROOM, AGENT, TABLE, FRIDGE, APPLE, CUP, STOOL, LAMP, CUPBOARD, PEAR = range(1, 11)


def node(identifier, name, *properties, states=(), category="Props"):
    return {
        "id": identifier,
        "class_name": name,
        "category": category,
        "properties": list(properties),
        "states": list(states),
    }


def edge(source, relation, target):
    return {"from_id": source, "relation_type": relation, "to_id": target}


@pytest.fixture
def small_home():
    """A kitchen: an apple in a closed fridge, a cup, a stool and a pear, nothing close yet."""
    return {
        "nodes": [
            node(ROOM, "kitchen", category="Rooms"),
            node(AGENT, "character", category="Characters"),
            node(TABLE, "table", "SURFACES"),
            node(FRIDGE, "fridge", "CAN_OPEN", "CONTAINERS", states=["CLOSED"]),
            node(APPLE, "apple", "GRABBABLE", "EATABLE", category="Food"),
            node(CUP, "cup", "GRABBABLE", "RECIPIENT"),
            node(STOOL, "stool", "SITTABLE"),
            node(LAMP, "lamp", "HAS_SWITCH", states=["OFF"]),
            node(
                CUPBOARD,
                "cupboard",
                "CAN_OPEN",
                "CONTAINERS",
                "HAS_SWITCH",
                states=["CLOSED", "ON"],
            ),
            node(PEAR, "pear", "GRABBABLE", "EATABLE", category="Food"),
        ],
        "edges": [
            *(edge(each, "INSIDE", ROOM) for each in range(AGENT, PEAR + 1)),
            edge(APPLE, "INSIDE", FRIDGE),
            edge(CUP, "ON", TABLE),
            edge(PEAR, "ON", TABLE),
        ],
    }


@pytest.fixture
def household():
    return worlds["household"]


@pytest.fixture
def home(household, small_home):
    """The small home as a world."""
    return household.open(Scene(world="household", graph=json.dumps(small_home)), 0)


@pytest.fixture
def do():
    """Performs calls written as text: ``find fridge; open fridge``."""

    def run(world, text):
        for call in text.split(";"):
            action, *names = call.split()
            for _ in world.perform(action, tuple(names)):
                pass

    return run


@pytest.fixture
def told():
    """What is true, as text."""

    def facts(world):
        return {str(fact) for fact in world.facts()}

    return facts
