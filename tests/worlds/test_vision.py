"""A vision model over HTTP as the cameras' detector: it gets pictures and names, and gives boxes."""

import base64
import io
import json
import re
import threading
from contextlib import contextmanager
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer

import mujoco
import numpy as np
import pytest
from PIL import Image

from app.domain.condition import Relation
from app.domain.errors import CompletionFailed, ModelUnavailable, Refused
from app.domain.perception import Perception
from app.domain.scene import Scene, SceneObject
from app.domain.sighting import Sighting
from app.llm.backend import Endpoint
from app.llm.transport import Patience, Transport
from app.llm.vision import VisionEndpoint
from app.worlds.simulators.mujoco.camera import CAMERAS
from app.worlds.simulators.mujoco.picture import Pictures
from app.worlds.simulators.mujoco.scene_builder import build
from app.worlds.simulators.mujoco.vision import masks
from app.worlds.tabletop import Tabletop

SEEING = Perception(detector="vision")
HUES = {"red block": (1, 0, 0), "blue bowl": (0, 0, 1), "green block": (0, 1, 0)}


@pytest.fixture(autouse=True)
def drawn_from_rays(monkeypatch):
    """The same pictures on every machine."""
    monkeypatch.delenv("MUJOCO_GL", raising=False)


def seen_by_colour(png, names):
    """What a modest model would tell: the box of everything of the colour in its name."""
    pixels = np.asarray(Image.open(io.BytesIO(png)).convert("RGB"), float) / 255
    height, width, _ = pixels.shape
    entries = []
    for name in names:
        hue = np.array(HUES[name])
        strong = pixels @ hue - (pixels @ (1 - hue)) / 2
        rows, columns = np.nonzero(strong > 0.25)
        if len(rows) > 3:
            box = [columns.min() / width, rows.min() / height]
            box += [(columns.max() + 1) / width, (rows.max() + 1) / height]
            entries.append({"name": name, "box": [round(1000 * float(side)) for side in box]})
    return "Here you are:\n```json\n" + json.dumps(entries) + "\n```"


@contextmanager
def service(answer):
    """A chat-completions endpoint; ``answer`` gets the picture and the names, and gives the text."""
    heard = []

    class Handler(BaseHTTPRequestHandler):
        def do_POST(self):
            body = json.loads(self.rfile.read(int(self.headers["Content-Length"])))
            heard.append((self.path, self.headers.get("Authorization"), body))
            text, image = body["messages"][0]["content"]
            kind, _, data = image["image_url"]["url"].partition(",")
            assert kind == "data:image/png;base64"
            (listed,) = re.findall(r"objects in it: (.*?)\. Answer", text["text"])
            told = answer(base64.b64decode(data), json.loads(f"[{listed}]"))
            message = {"role": "assistant", "content": told}
            said = json.dumps({"choices": [{"message": message}]}).encode()
            self.send_response(200)
            self.send_header("Content-Length", str(len(said)))
            self.end_headers()
            self.wfile.write(said)

        def log_message(self, format, *args):
            pass

    server = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
    thread = threading.Thread(target=server.serve_forever)
    thread.start()
    url = f"http://127.0.0.1:{server.server_port}/v1"
    try:
        yield VisionEndpoint(Endpoint(base_url=url, model="eyes", key="secret")), heard
    finally:
        server.shutdown()
        server.server_close()
        thread.join()


def scene():
    places = {"red block": (0.5, 0.2), "blue bowl": (0.5, -0.12), "green block": (0.4, 0.0)}
    return Scene(
        world="tabletop",
        objects=tuple(
            SceneObject(name=name, colour=name.split()[0], position=(*place, 0.0), yaw=0.0)
            for name, place in places.items()
        ),
    )


@pytest.mark.physics
def test_a_robot_that_is_told_by_a_vision_model_picks_and_places():
    tabletop = Tabletop()
    with service(seen_by_colour) as (endpoint, heard):
        tabletop.look_with(endpoint)
        world = tabletop.open(scene(), 0, SEEING)
        for _ in world.perform("grab_and_putin", ("red block", "blue bowl")):
            pass
    assert world.holds(Relation("in", ("red block", "blue bowl")))
    path, key, body = heard[0]
    assert (path, key, body["model"]) == ("/v1/chat/completions", "Bearer secret", "eyes")
    assert len(heard) < 60


@pytest.mark.physics
def test_where_the_model_takes_one_for_another_the_wrong_one_is_moved():
    def mistaken(png, names):
        told = seen_by_colour(png, names)
        return told.replace("red", "?").replace("green", "red").replace("?", "green")

    tabletop = Tabletop()
    with service(mistaken) as (endpoint, _):
        tabletop.look_with(endpoint)
        world = tabletop.open(scene(), 0, SEEING)
        for _ in world.perform("grab_and_putin", ("red block", "blue bowl")):
            pass
    assert world.holds(Relation("in", ("green block", "blue bowl")))
    assert not world.holds(Relation("in", ("red block", "blue bowl")))


@pytest.mark.physics
def test_nothing_is_asked_again_while_nothing_moves():
    own = Tabletop()
    with service(seen_by_colour) as (endpoint, heard):
        own.look_with(endpoint)
        cell = own.open(scene(), 0, SEEING)._cell
        seen = cell.look_at("red block")
        asked = len(heard)
        cell.physics.wake()
        cell.look_at("blue bowl")
    assert set(seen) == set(HUES)
    assert len(heard) == asked == 3


def test_without_a_vision_model_it_is_said_how_to_get_one():
    with pytest.raises(Refused, match="PROGPROMPT_VISION_URL") as refused:
        Tabletop().open(scene(), 0, SEEING)
    assert refused.value.faults[0].field == "perception.detector"


ODD = {
    "no JSON": "I see a red block.",
    "no list": '{"name": "red block"}',
    "no objects": "[1, 2]",
    "no place": '[{"name": "red block"}]',
    "too far": '[{"name": "red block", "box": [0, 0, 2000, 10]}]',
    "an empty box": '[{"name": "red block", "box": [20, 20, 10, 40]}]',
    "words": '[{"name": "red block", "point": ["left", "top"]}]',
}


@pytest.mark.parametrize("how", ODD)
def test_an_answer_that_is_none_is_told_as_it_stands(how):
    with (
        service(lambda *_: ODD[how]) as (endpoint, _),
        pytest.raises(CompletionFailed, match="vision model gave"),
    ):
        endpoint.find(b"", ["red block"])


def test_what_was_not_asked_for_is_passed_over_and_each_is_told_once():
    told = [
        {"name": "cat", "box": "everywhere"},
        {"name": "red block", "point": [500, 250]},
        {"name": "red block", "box": [0, 0, 10, 10]},
    ]
    with service(lambda *_: json.dumps(told)) as (endpoint, _):
        assert endpoint.find(b"", ["red block"]) == (Sighting(name="red block", point=(0.5, 0.25)),)


def test_a_service_that_is_not_there_is_named():
    nowhere = Endpoint(base_url="http://127.0.0.1:9/v1", model="eyes")
    once = Transport(nowhere.base_url, patience=Patience(attempts=1))
    endpoint = VisionEndpoint(nowhere, once)
    with pytest.raises(ModelUnavailable, match=r"127\.0\.0\.1:9"):
        endpoint.find(b"", ["cup"])


@pytest.mark.physics
def test_where_nothing_can_be_rendered_the_picture_is_drawn_from_rays(
    tabletop, monkeypatch, caplog
):
    def broken(*_):
        raise mujoco.FatalError("no OpenGL")

    monkeypatch.setenv("MUJOCO_GL", "egl")
    monkeypatch.setattr(mujoco, "Renderer", broken)
    completed = tabletop.complete(scene(), 0)
    cell = tabletop.open(completed, 0)._cell
    picture = Pictures(cell.physics, lambda: build(completed).model).take(CAMERAS[0])
    assert picture.shape == (240, 320, 3)
    assert "no OpenGL" in caplog.text


def test_a_box_within_another_takes_only_what_has_its_colour():
    objects = np.zeros((10, 10), bool)
    objects[1:9, 1:9] = True  # a bowl, and a banana in it
    colours = np.zeros((10, 10, 3))
    colours[..., 2] = 0.8
    colours[4:6, 3:7] = (0.9, 0.8, 0.1)
    bowl = Sighting(name="bowl", box=(0.0, 0.0, 1.0, 1.0))
    banana = Sighting(name="banana", box=(0.2, 0.2, 0.8, 0.8))
    found = masks([bowl, banana], objects, colours)
    assert found["banana"].sum() == 8
    assert (found["bowl"] | found["banana"]).sum() == 64
    assert not (found["bowl"] & found["banana"]).any()


def test_a_point_takes_the_patch_of_its_colour():
    objects = np.ones((10, 10), bool)
    colours = np.zeros((10, 10, 3))
    colours[2:5, 2:5] = colours[7:9, 7:9] = 1.0
    found = masks([Sighting(name="cup", point=(0.3, 0.3))], objects, colours)
    assert found["cup"].sum() == 9


@pytest.mark.physics
def test_a_picture_shows_the_objects_in_their_colours(tabletop):
    completed = tabletop.complete(scene(), 0)
    cell = tabletop.open(completed, 0)._cell
    picture = Pictures(cell.physics, lambda: build(completed).model).take(CAMERAS[0])
    for hue in HUES.values():
        strong = picture / 255.0 @ np.array(hue) - picture / 255.0 @ (1 - np.array(hue)) / 2
        assert (strong > 0.25).sum() > 20
