"""WebSocketRobot: streams joint trajectories as JSON to whatever drives a real arm.

Every message is one JSON object with a ``type``. Units are [s], [rad], [m], [N]. The driver sends:

- ``{"type": "hello", "protocol": 1, "joints": n, "speed": […], "workspace": [[x, y, z], [x, y, z]],
  "grip_force": F, "contact_force": F}`` once, with the limits the peer is to enforce as well;
- ``{"type": "trajectory", "points": n, "duration": T, "grip_force": F}``;
- ``{"type": "points", "first": i, "times": […], "positions": [[…n], …], "openings": […]}``, up to
  ``CHUNK`` points each, the next one only when the one before is accepted;
- ``{"type": "end"}`` after the last point;
- ``{"type": "stop", "reason": "…"}`` at any time: hold still at once; nothing follows.

The peer answers ``hello`` with ``{"type": "ready", "positions": […n]}``, where its joints are now;
``points`` with ``{"type": "accepted", "until": i}``, ``i`` the index after the last point it took;
``end`` with ``{"type": "done"}`` once it stands at the last point, and until then at least every
``patience`` seconds with ``{"type": "moving", "time": t}``. Any of these may carry ``"force": F``,
what presses on the arm. ``{"type": "fault", "reason": "…"}`` says that it stopped by itself.

A peer that is silent for ``patience`` seconds, reports too much force or says anything else is told
to stop, and the connection ends. A peer must hold still when the connection ends without ``done``.
"""

import json
from typing import Any, NoReturn

from websockets.exceptions import WebSocketException
from websockets.sync.client import connect
from websockets.sync.connection import Connection

from app.domain.robot import (
    Carried,
    JointTrajectory,
    RobotLimits,
    RobotStopped,
    TrajectoryRefused,
)
from app.robots.arm_model import ArmModel
from app.robots.limits import check

PROTOCOL = 1
CHUNK = 32
"""Points of one message: about a second of motion."""
NEAR = 0.05
"""How far a joint may be from the first point when a trajectory begins [rad]."""
LARGEST_ANSWER = 65_536  # bytes


class WebSocketRobot:
    """A ``Robot`` at the other end of a WebSocket; without ``live`` it only checks."""

    def __init__(
        self,
        url: str,
        arm: ArmModel,
        *,
        live: bool = False,
        limits: RobotLimits | None = None,
        patience: float = 2.0,
    ) -> None:
        """Connect to nothing yet.

        Args:
            url: of the peer, ``ws://…`` or ``wss://…``.
            arm: which arm it is.
            live: send; else trajectories are checked and recorded only.
            limits: enforced here before anything is sent; None for the arm's own.
            patience: the longest silence of the peer [s].
        """
        self.limits = limits or arm.limits
        self._arm = arm
        self.recorded: list[JointTrajectory] = []
        """Those that were let through, in order."""
        self._url = url
        self._live = live
        self._patience = patience

    def execute(self, trajectory: JointTrajectory) -> Carried:
        """Check the trajectory, and if live, send it and wait until the arm is at its end.

        Raises:
            TrajectoryRefused: it breaks a limit, or does not begin where the arm is.
            RobotStopped: the peer cannot be reached, is silent, presses too hard or gave up.
        """
        check(trajectory, self.limits, self._arm.forward)
        self.recorded.append(trajectory)
        if self._live:
            self._send(trajectory)
        return Carried(points=len(trajectory.times), duration=trajectory.duration, live=self._live)

    def _send(self, trajectory: JointTrajectory) -> None:
        try:
            with connect(
                self._url,
                open_timeout=self._patience,
                close_timeout=self._patience,
                max_size=LARGEST_ANSWER,
                proxy=None,
            ) as connection:
                _Stream(connection, self.limits, self._patience).send(trajectory)
        except (OSError, WebSocketException, ValueError) as error:
            reason = str(error) or type(error).__name__
            raise RobotStopped(f"lost the robot at {self._url}: {reason}") from error


class _Stream:
    """One trajectory on one connection."""

    def __init__(self, connection: Connection, limits: RobotLimits, patience: float) -> None:
        self._connection = connection
        self._limits = limits
        self._patience = patience

    def send(self, trajectory: JointTrajectory) -> None:
        self._say(
            "hello",
            protocol=PROTOCOL,
            joints=len(self._limits.speed),
            speed=self._limits.speed,
            workspace=self._limits.workspace,
            grip_force=self._limits.grip_force,
            contact_force=self._limits.contact_force,
        )
        self._check_start(self._hear("ready").get("positions"), trajectory)
        count = len(trajectory.times)
        self._say(
            "trajectory",
            points=count,
            duration=trajectory.duration,
            grip_force=trajectory.grip_force,
        )
        for first in range(0, count, CHUNK):
            part = slice(first, first + CHUNK)
            self._say(
                "points",
                first=first,
                times=trajectory.times[part],
                positions=trajectory.positions[part],
                openings=trajectory.openings[part],
            )
            until = self._hear("accepted").get("until")
            if until != min(first + CHUNK, count):
                self._stop(f"the robot accepted points until {until!r}")
        self._say("end")
        while self._hear("moving", "done")["type"] != "done":
            pass

    def _check_start(self, standing: object, trajectory: JointTrajectory) -> None:
        first = trajectory.positions[0]
        if not isinstance(standing, list) or len(standing) != len(first):
            self._stop("the robot does not say where its joints are")
        for joint, (here, there) in enumerate(zip(standing, first, strict=True), start=1):
            apart = abs(_number(here) - there)
            if not apart <= NEAR:  # what is no number is not near
                self._say("stop", reason="the trajectory begins elsewhere")
                raise TrajectoryRefused(
                    "start",
                    f"is {apart:.3f} rad from where joint {joint} of the robot is; "
                    f"at most {NEAR} rad is allowed",
                )

    def _hear(self, *expected: str) -> dict[str, Any]:
        """The next message, which is to be of one of these types."""
        try:
            said = json.loads(self._connection.recv(timeout=self._patience))
        except TimeoutError:
            self._stop(f"the robot was silent for {self._patience:g} s")
        except ValueError:
            self._stop("the robot answered with what is no JSON")
        if not isinstance(said, dict) or said.get("type") not in expected:
            self._stop(f"the robot answered {str(said)[:200]}, not {' or '.join(expected)}")
        force = _number(said.get("force", 0.0))
        if not force <= self._limits.contact_force:
            most = self._limits.contact_force
            self._stop(f"contact_force: {force:.1f} N press on the robot; at most {most:.1f} N may")
        return said

    def _say(self, kind: str, **members: object) -> None:
        self._connection.send(json.dumps({"type": kind, **members}))

    def _stop(self, reason: str) -> NoReturn:
        self._say("stop", reason=reason)
        raise RobotStopped(reason)


def _number(value: object) -> float:
    """Of JSON; what is none is not a number."""
    return float(value) if isinstance(value, int | float) else float("nan")
