"""A model of a hinged arm and a free block, and a second of its motion."""

import contextlib
import threading
import time

import msgspec
import mujoco
import numpy as np
import pytest
import uvicorn
import viser
import zstandard
from fastapi import FastAPI
from websockets.sync.client import connect
from websockets.typing import Subprotocol

from app.api.errors import install
from app.api.resources.viewer import router
from app.domain.errors import NotThere
from app.view.viewer import Viewer

MODEL = """
<mujoco>
  <worldbody>
    <geom name="floor" type="plane" size="0 0 1"/>
    <body name="arm" pos="0 0 0.5">
      <joint name="turn" axis="0 0 1"/>
      <geom type="capsule" size="0.03 0.1" group="2"/>
      <geom type="box" size="0.1 0.1 0.1" group="3"/>
    </body>
    <body name="object/0" pos="0.3 0 0.1">
      <freejoint/>
      <geom type="box" size="0.02 0.02 0.02" rgba="1 0 0 1"/>
    </body>
  </worldbody>
</mujoco>
"""


@pytest.fixture(scope="session")
def model():
    return mujoco.MjModel.from_xml_string(MODEL)


@pytest.fixture(scope="session")
def frames(model):
    """Thirty frames of the arm turning by a radian and the block rising by a metre; (30, 9)."""
    times = np.arange(30) / 30
    rows = np.tile(np.concatenate(([0.0], model.qpos0)), (30, 1))
    rows[:, 0] = rows[:, 1] = times
    rows[:, 4] += times
    return rows


class Rollout:
    """A rollout that somebody lets grow."""

    def __init__(self, model, frames, known=None):
        self._model = model
        self._frames = frames
        self.known = len(frames) if known is None else known
        self.asked = []

    def model(self):
        return self._model

    def frames(self, after):
        self.asked.append(after)
        return self._frames[after : self.known]

    def finished(self):
        return self.known == len(self._frames)


@pytest.fixture
def rollout(model, frames):
    return Rollout(model, frames)


@pytest.fixture
def growing(model, frames):
    return Rollout(model, frames, known=10)


@pytest.fixture
def rollouts(rollout, growing):
    """Finds them by the ids ``done`` and ``live``."""

    def find(execution_id):
        known = {"done": rollout, "live": growing}
        if execution_id not in known:
            raise NotThere("execution", execution_id)
        return known[execution_id]

    return find


@pytest.fixture
def viewer(rollouts):
    return Viewer(rollouts)


@pytest.fixture
def address(viewer):
    """Host and port of a service that has nothing but the viewer."""
    app = FastAPI()
    app.include_router(router)
    install(app)
    app.state.viewer = viewer
    server = uvicorn.Server(uvicorn.Config(app, port=0, log_level="error", lifespan="off"))
    thread = threading.Thread(target=server.run)
    thread.start()
    deadline = time.monotonic() + 20
    while not server.started:
        assert time.monotonic() < deadline
        time.sleep(0.02)
    yield f"127.0.0.1:{server.servers[0].sockets[0].getsockname()[1]}"
    server.should_exit = True
    thread.join(20)


class Browser:
    """What viser's client does, without the pictures: takes messages, says where its camera is."""

    def __init__(self, url):
        protocol = Subprotocol(f"viser-v{viser.__version__}")
        self.socket = connect(url, subprotocols=[protocol], max_size=None, compression=None)
        camera = {
            "type": "ViewerCameraMessage",
            "wxyz": (1.0, 0.0, 0.0, 0.0),
            "position": (1.0, 1.0, 1.0),
            "fov": 1.0,
            "near": 0.01,
            "far": 100.0,
            "image_height": 100,
            "image_width": 100,
            "look_at": (0.0, 0.0, 0.0),
            "up_direction": (0.0, 0.0, 1.0),
        }
        self.socket.send(msgspec.msgpack.encode(camera))
        self.glbs = set()
        self.positions = {}

    def close(self):
        self.socket.close()

    def watch(self, until, limit=20.0):
        """Take messages until ``until(self)`` is true."""
        deadline = time.monotonic() + limit
        while not until(self):
            assert time.monotonic() < deadline, "it did not come to that"
            with contextlib.suppress(TimeoutError):
                self._take(self.socket.recv(timeout=0.1))

    def _take(self, batch):
        size = int.from_bytes(batch[8:16], "little")
        inner = zstandard.ZstdDecompressor().decompress(batch[16 : 16 + size])
        for message in msgspec.msgpack.decode(inner)["messages"]:
            if message["type"] == "GlbMessage":
                self.glbs.add(message["name"])
            if message["type"] == "SetPositionMessage":
                self.positions.setdefault(message["name"], []).append(message["position"])


@pytest.fixture
def open_browser():
    with contextlib.ExitStack() as stack:
        yield lambda url: stack.enter_context(contextlib.closing(Browser(url)))
