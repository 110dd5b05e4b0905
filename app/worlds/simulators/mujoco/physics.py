"""Physics: owns the MuJoCo model and data, steps them, and samples frames."""

import struct

import mujoco
import numpy as np
from numpy.typing import NDArray

from app.domain.trace import Frame
from app.worlds.simulators.mujoco.rubbing import EVERY, Rubbing
from app.worlds.simulators.mujoco.scene_builder import BuiltScene, ObjectBody

Array = NDArray[np.float64]

FRAME_RATE = 30.0
"""Frames per second of simulated time [1/s]."""
REST_SPEED = 0.01
"""Slower than this, an object counts as resting [m/s] and, times ten, [rad/s]."""
REST_SECONDS = 0.1
"""How long nothing may move before everything counts as resting [s]."""
LONGEST_SETTLING = 3.0
"""After this long, what still rolls is left to roll [s]."""
FRICTION_STIFFNESS = 50.0
"""Of friction against normal forces. At 10, round things creep out of the fingers while carried."""
_EVERYTHING = int(mujoco.mjtState.mjSTATE_INTEGRATION)
_HEADER = struct.Struct("<QQQ")


class Physics:
    """A scene in motion. Time is simulated, in steps of the model's time step.

    Whatever looks at the scene does so through ``stand``, which depends on ``qpos`` alone, so that
    looking is the same before and after ``restore``.
    """

    def __init__(self, built: BuiltScene) -> None:
        self.model = built.model
        # What rests and is not touched costs nothing: five times as many steps a second.
        self.model.opt.enableflags |= int(mujoco.mjtEnableBit.mjENBL_SLEEP)
        self.bodies = built.bodies
        self.beads = built.beads
        self.arm = built.arm
        self._gripper = self.arm.joints  # its place in ``ctrl``
        self.model.opt.impratio = FRICTION_STIFFNESS
        self.data = mujoco.MjData(self.model)
        self._view = mujoco.MjData(self.model)
        self._timestep: float = self.model.opt.timestep
        self._steps = 0
        self._sampled = 0
        self._frames: list[Frame] = []
        fingers = tuple(int(self.model.body(name).id) for name in self.arm.fingers)
        wiping = self.model.nuserdata > 0
        self.rubbing = Rubbing(self.model, self.bodies, fingers) if wiping else None
        """Where tops were rubbed, in scenes whose robot wipes."""
        self.woken = 0
        """How often ``wake`` was called: a number for the action that is under way."""
        arm, opened = self.arm, self.arm.largest_opening
        self.data.qpos[arm.arm_part] = arm.home
        self.data.qpos[arm.finger_part] = arm.finger_joints_at(opened)
        for body in built.bodies.values():
            if body.joint is not None:
                self.data.qpos[self.model.jnt_qposadr[body.joint]] = body.start
        self.command(arm.home, opened)

    @property
    def time(self) -> float:
        """Simulated time since the rollout began [s]."""
        return self._steps * self._timestep

    @property
    def steps(self) -> int:
        """Time steps since the rollout began."""
        return self._steps

    @property
    def joints(self) -> Array:
        """The arm's joint angles now, shape (n,) [rad]."""
        return self.data.qpos[self.arm.arm_part].copy()

    @property
    def opening(self) -> float:
        """How far each finger is from the middle, on average [m]."""
        return self.arm.opening_at(self.data.qpos[self.arm.finger_part])

    @property
    def commanded_joints(self) -> Array:
        """The joint angles the arm is told to be at, shape (n,) [rad]."""
        return self.data.ctrl[self.arm.arm_part].copy()

    @property
    def commanded_opening(self) -> float:
        """How far each finger is told to be from the middle [m]."""
        return self.arm.commanded_at(float(self.data.ctrl[self._gripper]))

    def wake(self) -> None:
        """Wake what sleeps; from here on, all depends on nothing but what ``save`` keeps.

        To be called at the start of every action, so that it goes on alike before and after
        ``restore``. Which bodies sleep is not part of MuJoCo's integration state.
        """
        self.woken += 1
        state = self._state()
        mujoco.mj_resetData(self.model, self.data)
        mujoco.mj_setState(self.model, self.data, state, _EVERYTHING)

    def command(self, joints: Array | None = None, opening: float | None = None) -> None:
        """Tell the arm's joints [rad] and the fingers [m] where to be; takes effect with steps."""
        if joints is not None:
            self.data.ctrl[self.arm.arm_part] = joints
        if opening is not None:
            self.data.ctrl[self._gripper] = self.arm.control_at(opening)

    def step(self) -> None:
        """Go on by one time step."""
        if self._steps * self._timestep * FRAME_RATE >= self._sampled:
            self._sample()
        mujoco.mj_step(self.model, self.data)
        self._steps += 1
        if self.rubbing and self._steps % EVERY == 0 and self._closed():
            self.rubbing.observe(self.data)

    def begin(self) -> None:
        """Let everything settle, then call it time 0."""
        self.settle()
        self.rewind()

    def rewind(self) -> None:
        """Call it time 0, whatever went before."""
        self.data.time = 0.0
        self._steps = self._sampled = 0
        self._frames = []

    def settle(self) -> None:
        """Go on until nothing has moved for ``REST_SECONDS``, or until ``LONGEST_SETTLING``."""
        self.wake()
        still = 0
        for _ in range(self.steps_in(LONGEST_SETTLING)):
            self.step()
            still = still + 1 if self.resting() else 0
            if still >= self.steps_in(REST_SECONDS):
                break

    def steps_in(self, seconds: float) -> int:
        """The number of time steps in a duration [s]."""
        return max(1, round(seconds / self._timestep))

    def resting(self) -> bool:
        """Whether no object moves noticeably."""
        for body in self.bodies.values():
            speed = self.data.qvel[body.dof_address : body.dof_address + 6]
            moving = np.linalg.norm(speed[:3]) > REST_SPEED
            turning = np.linalg.norm(speed[3:]) > 10 * REST_SPEED
            if moving or turning:
                return False
        return True

    def height_of(self, body: ObjectBody) -> float:
        """Height of an object's origin above the table [m]."""
        return float(self.data.qpos[body.qpos_address + 2])

    def is_level(self, name: str) -> bool:
        """Whether an object has a level top that can be wiped."""
        return self.rubbing is not None and self.rubbing.is_level(name)

    def stand(self) -> mujoco.MjData:
        """How everything stands: poses from ``qpos``.

        Not the data that is stepped, but a view of it that is good until the next call.
        """
        self._view.qpos[:] = self.data.qpos
        mujoco.mj_kinematics(self.model, self._view)
        return self._view

    def frames(self) -> tuple[Frame, ...]:
        """The frames sampled since the last call."""
        frames, self._frames = tuple(self._frames), []
        return frames

    def save(self) -> bytes:
        """Everything the future depends on: integration state with warm start, counters, frames."""
        state = self._state()
        waiting = [(frame.time, *frame.positions) for frame in self._frames]
        header = _HEADER.pack(self._steps, self._sampled, len(waiting))
        return header + state.tobytes() + np.array(waiting, float).tobytes()

    def restore(self, saved: bytes) -> None:
        """Take up a state that ``save`` gave; continues bit for bit.

        Raises:
            ValueError: the state is of another model.
        """
        self._steps, self._sampled, waiting = _HEADER.unpack_from(saved)
        numbers = np.frombuffer(saved, offset=_HEADER.size)
        size = mujoco.mj_stateSize(self.model, _EVERYTHING)
        if len(numbers) != size + waiting * (1 + self.model.nq):
            raise ValueError("the saved state is of another scene")
        mujoco.mj_resetData(self.model, self.data)
        mujoco.mj_setState(self.model, self.data, numbers[:size].copy(), _EVERYTHING)
        rows = numbers[size:].reshape(waiting, 1 + self.model.nq).tolist()
        self._frames = [Frame(time=row[0], positions=tuple(row[1:])) for row in rows]

    def _closed(self) -> bool:
        return self.commanded_opening < self.arm.largest_opening - 1e-9

    def _state(self) -> Array:
        state = np.empty(mujoco.mj_stateSize(self.model, _EVERYTHING))
        mujoco.mj_getState(self.model, self.data, state, _EVERYTHING)
        return state

    def _sample(self) -> None:
        positions = tuple(self.data.qpos.tolist())
        self._frames.append(Frame(time=self.time, positions=positions))
        self._sampled += 1
