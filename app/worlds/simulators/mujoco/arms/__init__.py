"""The robot arms of the tabletop, one a file."""

from app.registry import Registry
from app.worlds.simulators.mujoco.arm import Arm

arms: Registry[Arm] = Registry(__name__, "robot")
DEFAULT_ARM = "panda"
"""The one that stands at the table unless a scene names another."""
