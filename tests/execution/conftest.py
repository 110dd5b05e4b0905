import json

import pytest

from app.domain.condition import Relation
from app.domain.errors import ActionFailure
from app.domain.scene import Scene
from app.domain.world import Stage


class SlipperyWorld:
    """Puts one thing into another, in three stages; each name slips as often as it is told to."""

    scene = Scene(world="slippery")

    def __init__(self, **slips):
        self.time = 0.0
        self.inside = {}
        self.slips = dict(slips)
        self.settled = 0

    def perform(self, action, arguments):
        thing, place = arguments
        for stage in ("reach", "reach", "grasp", "carry"):
            self.time += 0.1
            yield Stage(name=stage)
        if self.slips.get(thing, 0) > 0:
            self.slips[thing] -= 1
            raise ActionFailure("carry", f"{thing} slipped")
        self.inside[thing] = place

    def holds(self, relation):
        return relation in self.facts()

    def facts(self):
        return frozenset(Relation("in", pair) for pair in self.inside.items())

    def begin(self):
        self.time = 0.0

    def settle(self):
        self.settled += 1
        self.time += 1.0

    def frames(self):
        return ()

    def save(self):
        return json.dumps([self.time, self.inside, self.slips]).encode()

    def restore(self, state):
        self.time, self.inside, self.slips = json.loads(state)


@pytest.fixture
def slippery():
    return SlipperyWorld
