"""The driver of a real arm, against a real WebSocket server that plays the arm."""

import json
import threading
import time
from contextlib import contextmanager
from dataclasses import replace
from itertools import chain

import numpy as np
import pytest
from websockets.exceptions import ConnectionClosed
from websockets.sync.server import serve

from app.domain.robot import JointTrajectory, RobotStopped, TrajectoryRefused
from app.domain.scene import Scene, SceneObject
from app.robots.playback import trajectory_of
from app.robots.websocket import CHUNK, WebSocketRobot
from app.worlds.simulators.mujoco.arms import arms
from app.worlds.tabletop import Tabletop

PANDA = arms["panda"]
HOME = (0.0, -0.35, 0.0, -2.3, 0.0, 1.95, 0.785)
POINTS = 2 * CHUNK + 5


def swing(joint=0, by=0.5, seconds=3.0, **other):
    """The arm at home, one joint turning by an angle [rad] and the gripper closing."""
    share = np.linspace(0.0, 1.0, POINTS)
    positions = np.tile(HOME, (POINTS, 1))
    positions[:, joint] += by * share
    values = {
        "times": tuple((seconds * share).tolist()),
        "positions": tuple(tuple(row) for row in positions.tolist()),
        "openings": tuple((0.08 * (1 - share)).tolist()),
    }
    return JointTrajectory(**{**values, **other})


class Arm:
    """Takes what it is sent; ``oddly`` says what it answers to a type instead, None for nothing."""

    def __init__(self, standing=HOME, **oddly):
        self.heard = []
        self.ended = threading.Event()
        self._standing = list(standing)
        self._oddly = oddly

    def __call__(self, connection):
        try:
            for text in connection:
                message = json.loads(text)
                self.heard.append(message)
                for answer in self._answers(message):
                    connection.send(answer if isinstance(answer, str) else json.dumps(answer))
        except ConnectionClosed:
            pass
        finally:
            self.ended.set()

    def _answers(self, message):
        kind = message["type"]
        if kind in self._oddly:
            odd = self._oddly[kind]
            return [] if odd is None else [odd]
        if kind == "points":
            return [{"type": "accepted", "until": message["first"] + len(message["times"])}]
        if kind == "end":
            return [{"type": "moving", "time": 1.0, "force": 3.0}, {"type": "done"}]
        return [{"type": "ready", "positions": self._standing}] if kind == "hello" else []

    def types(self):
        return [message["type"] for message in self.heard]


@contextmanager
def listening(arm):
    with serve(arm, "127.0.0.1", 0) as server:
        thread = threading.Thread(target=server.serve_forever)
        thread.start()
        yield f"ws://127.0.0.1:{server.socket.getsockname()[1]}"
        server.shutdown()
    thread.join()


def test_every_point_arrives_in_order_and_the_end_is_waited_for():
    arm, trajectory = Arm(), swing()
    with listening(arm) as url:
        carried = WebSocketRobot(url, PANDA, live=True).execute(trajectory)
    assert (carried.points, carried.live) == (POINTS, True)
    assert arm.types() == ["hello", "trajectory", "points", "points", "points", "end"]
    parts = arm.heard[2:5]
    assert [part["first"] for part in parts] == [0, CHUNK, 2 * CHUNK]
    for name in ("times", "openings"):
        assert tuple(chain(*(part[name] for part in parts))) == getattr(trajectory, name)
    sent = chain(*(part["positions"] for part in parts))
    assert tuple(map(tuple, sent)) == trajectory.positions


def test_unless_it_is_live_nobody_is_connected_to():
    arm = Arm()
    with listening(arm) as url:
        robot = WebSocketRobot(url, PANDA)
        carried = robot.execute(swing())
    assert not carried.live
    assert robot.recorded == [swing()]
    assert arm.heard == []


BROKEN = {
    "speed": swing(by=0.9, seconds=0.3),
    "joint_range": swing(3, by=2.4, seconds=10.0),
    "workspace": swing(1, by=1.2, seconds=10.0),
    "grip_force": swing(grip_force=71.0),
    "opening": swing(openings=(0.1,) * POINTS),
    "times": swing(times=(0.0,) * POINTS),
    "points": swing(times=(float("nan"),) * POINTS),
    "positions": swing(positions=(HOME[:6],) * POINTS),
}


@pytest.mark.parametrize("limit", BROKEN)
def test_a_trajectory_that_breaks_a_limit_is_refused_before_anything_is_sent(limit):
    arm = Arm()
    with listening(arm) as url:
        robot = WebSocketRobot(url, PANDA, live=True)
        with pytest.raises(TrajectoryRefused) as refused:
            robot.execute(BROKEN[limit])
    assert refused.value.faults[0].field == limit
    assert arm.heard == []
    assert robot.recorded == []


def test_the_workspace_is_kept_to_between_two_points_as_well():
    there = (*HOME[:1], 1.3, *HOME[2:])
    corner = swing()
    first = replace(
        corner, times=(0.0, 5.0, 10.0), positions=(HOME, there, HOME), openings=(0.0,) * 3
    )
    with pytest.raises(TrajectoryRefused, match="workspace"):
        WebSocketRobot("ws://127.0.0.1:9", PANDA).execute(first)
    low, high = PANDA.limits.workspace
    narrow = replace(PANDA.limits, workspace=((low[0], -0.1, low[2]), (high[0], 0.1, high[2])))
    turned = (2.2, *HOME[1:])  # from side to side past the front, both ends behind the robot
    around = replace(
        corner,
        times=(0.0, 5.0),
        positions=((-3.0 + 0.2, *HOME[1:]), turned),
        openings=(0.0,) * 2,
    )
    with pytest.raises(TrajectoryRefused, match="workspace"):
        WebSocketRobot("ws://127.0.0.1:9", PANDA, limits=narrow).execute(around)


STALLS = {
    "silent at once": ({"hello": None}, "silent"),
    "silent on the way": ({"points": None}, "silent"),
    "silent at the end": ({"end": None}, "silent"),
    "pressed hard": (
        {"points": {"type": "accepted", "until": CHUNK, "force": 55.0}},
        "contact_force",
    ),
    "no force": ({"points": {"type": "accepted", "until": CHUNK, "force": "x"}}, "contact_force"),
    "at fault": ({"end": {"type": "fault", "reason": "reflex"}}, "reflex"),
    "losing points": ({"points": {"type": "accepted", "until": 3}}, "until 3"),
    "talking nonsense": ({"points": "{"}, "no JSON"),
}


@pytest.mark.parametrize("how", STALLS)
def test_a_peer_that_does_not_do_as_agreed_is_told_to_stop(how):
    oddly, reason = STALLS[how]
    arm = Arm(**oddly)
    with listening(arm) as url:
        began = time.monotonic()
        with pytest.raises(RobotStopped, match=reason):
            WebSocketRobot(url, PANDA, live=True, patience=0.2).execute(swing())
        assert time.monotonic() - began < 10.0
        assert arm.ended.wait(5.0)
    assert arm.types()[-1] == "stop"
    assert arm.types().count("stop") == 1


def test_an_arm_that_stands_elsewhere_gets_no_point():
    arm = Arm(standing=(0.3, *HOME[1:]))
    with listening(arm) as url, pytest.raises(TrajectoryRefused, match=r"start.*joint 1"):
        WebSocketRobot(url, PANDA, live=True).execute(swing())
    assert arm.ended.wait(5.0)
    assert arm.types() == ["hello", "stop"]


def test_a_robot_that_cannot_be_reached_is_named():
    with pytest.raises(RobotStopped, match=r"ws://127\.0\.0\.1:9"):
        WebSocketRobot("ws://127.0.0.1:9", PANDA, live=True).execute(swing())


def sweeping(arm):
    """Frames in which an arm swings from side to side, its gripper open, and their width."""
    times = np.linspace(0.0, 2.0, 61)
    frames = np.zeros((61, 1 + arm.joints + arm.finger_joints + 7))
    frames[:, 0] = times
    frames[:, 1 : 1 + arm.joints] = arm.home
    frames[:, 1] += 0.5 * times
    fingers = arm.finger_joints_at(arm.largest_opening)
    frames[:, 1 + arm.joints :][:, : arm.finger_joints] = fingers
    return frames.astype("<f4").tobytes(), frames.shape[1]


@pytest.mark.parametrize("name", arms)
def test_what_every_arm_did_is_sent_with_its_own_joints_and_opening(name):
    arm = arms[name]
    peer = Arm(standing=arm.home.tolist())
    trajectory = trajectory_of(*sweeping(arm), arm)
    with listening(peer) as url:
        carried = WebSocketRobot(url, arm, live=True).execute(trajectory)
    assert carried.points == 61
    assert peer.heard[0]["joints"] == arm.joints
    assert {len(row) for row in trajectory.positions} == {arm.joints}
    assert trajectory.openings == pytest.approx([2 * arm.largest_opening] * 61, abs=1e-4)


@pytest.mark.parametrize("name", arms)
@pytest.mark.parametrize("limit", ["speed", "workspace", "grip_force"])
def test_no_arm_gets_a_trajectory_beyond_its_own_limits(name, limit):
    arm = arms[name]
    trajectory = trajectory_of(*sweeping(arm), arm)
    limits = arm.limits
    if limit == "workspace":
        limits = replace(limits, workspace=((-0.1, -0.8, -0.005), (0.2, 0.8, 1.0)))
    if limit == "speed":
        limits = replace(limits, speed=(0.4,) * arm.joints)
    if limit == "grip_force":
        trajectory = replace(trajectory, grip_force=limits.grip_force + 1)
    with pytest.raises(TrajectoryRefused) as refused:
        WebSocketRobot("ws://127.0.0.1:9", arm, limits=limits).execute(trajectory)
    assert refused.value.faults[0].field == limit


@pytest.mark.physics
@pytest.mark.parametrize("name", arms)
def test_what_every_arm_does_in_simulation_keeps_to_its_limits(name):
    objects = tuple(SceneObject(name=each) for each in ("banana", "bowl", "can"))
    world = Tabletop().open(Scene(world="tabletop", robot=name, objects=objects), 3)
    for _ in world.perform("grab_and_putin", ("banana", "bowl")):
        pass
    frames = np.array([(frame.time, *frame.positions) for frame in world.frames()], "<f4")
    arm = arms[name]
    trajectory = trajectory_of(frames.tobytes(), frames.shape[1], arm)
    carried = WebSocketRobot("ws://127.0.0.1:9", arm).execute(trajectory)
    assert carried.points > 100
    assert min(trajectory.openings) < 0.06 < max(trajectory.openings)
