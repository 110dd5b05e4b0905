"""Whoever asks a robot for verbs, and gives it those that it has not got."""

from app.training.nouns import Nouns
from app.training.robots import Robot

PARAMETERS = (
    "obj",
    "item",
    "thing",
    "o",
    "object",
    "target",
    "part",
    "what",
    "obj1",
    "x",
    "it",
)
"""What a verb's first parameter may be called."""


class Actor:
    """Asks for a robot's other verbs."""

    def __init__(self, nouns: Nouns, robot: Robot) -> None:
        self.nouns = nouns
        self.words = nouns.words
        self.rng = nouns.rng
        self.robot = robot
