"""Articulation: the one moving part of a drawer, a door or a lid, and where it is taken hold of."""

from dataclasses import dataclass
from typing import Literal

Point = tuple[float, float, float]


@dataclass(frozen=True, slots=True, kw_only=True)
class Articulation:
    """A part on a joint. Everything is in the frame of the object's body, with the part shut [m].

    The front, where the handle is, faces -x; a scene turns it towards the robot.
    """

    joint: Literal["slide", "hinge"]
    axis: Point
    """Unit vector; a slide moves along it, a hinge turns about it, to open."""
    pivot: Point
    """Origin of the part's own frame; a hinge's axis goes through it."""
    travel: float
    """From shut to wholly open [m] or [rad]."""
    handle: Point
    """The middle of the fin the fingers close on, along the body's y."""
    thickness: float
    """Of the fin [m]."""
    friction: float
    """What it takes to move the part, so that it stays where it is left [N] or [Nm]."""
    holds: bool = False
    """The opening is in the part, as in a drawer, and its measures are in the part's frame."""
