"""Sentences that ask for what the robot cannot do, so that it declines."""

from app.training.acting import clause
from app.training.actor import Actor
from app.training.draft import Draft
from app.training.nouns import Nouns
from app.training.robots import NEAR, PUT, Robot
from app.training.said import fill
from app.training.steps import DECLINE, Step

ASKED_BY_PUTTING = {"SWEEP", "COVER", "ATTACH"}
"""Concepts that putting may do as well."""


def impossible(nouns: Nouns, robot: Robot) -> Draft:
    """What no verb of this robot does, or what no robot does."""
    words = nouns.words
    nothing = [Step(DECLINE, {})]
    if words.chance(0.45):
        bare = Robot(words.rng)
        text, _, order = clause(Actor(nouns, bare))
        wanted = set(bare.verbs)
        if (
            wanted & ASKED_BY_PUTTING
            or any(concept in robot.verbs for concept in wanted)
            or _near(robot, wanted)
        ):
            return impossible(nouns, robot)
        return Draft(text, nothing, order=order)
    template = words.say("refusals", "impossible")
    if any(f"plain {stem}" in robot.verbs for stem in template.split()[:1]) or len(robot.verbs) > 2:
        robot.verbs = {PUT: robot.verbs[PUT]}
    text = fill(template, {"x": nouns.names.bare()})
    return Draft(text, nothing)


def _near(robot: Robot, wanted: set[str]) -> bool:
    """Whether one of the robot's verbs might be taken for what is asked."""
    return any(wanted & group and group & set(robot.verbs) - {PUT} for group in NEAR)
