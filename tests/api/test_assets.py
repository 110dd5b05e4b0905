"""Own meshes: taken in, refused with what would help, stood on the table and handled."""

import numpy as np
import pytest
import trimesh
from click.testing import CliRunner

from app.cli import main
from app.storage.assets import lookup
from app.worlds import worlds
from app.worlds.simulators.mujoco import upload
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.tabletop import Tabletop

STL = {"Content-Type": "model/stl"}


def wedge(scale=1.0):
    """An L of two boxes, 60 by 40 by 40 mm: not convex."""
    lying = trimesh.creation.box((0.06, 0.04, 0.02))
    standing = trimesh.creation.box((0.02, 0.04, 0.02))
    lying.apply_translation((0, 0, 0.01))
    standing.apply_translation((0.02, 0, 0.03))
    return trimesh.util.concatenate([lying, standing]).apply_scale(scale)


def exported(mesh, form="stl"):
    data = mesh.export(file_type=form)
    return data.encode() if isinstance(data, str) else data


@pytest.fixture
def shelf(parts):
    """The tabletop finds the assets of this test's database."""
    tabletop = worlds["tabletop"]
    assert isinstance(tabletop, Tabletop)
    tabletop.assets(lookup(parts.database))
    yield
    kinds.assets.search(None)


def uploaded(client, mesh, form="stl", **query):
    media = {"stl": "model/stl", "obj": "model/obj", "glb": "model/gltf-binary"}[form]
    headers = {"Content-Type": media}
    return client.post("/assets", content=exported(mesh, form), headers=headers, params=query)


def test_a_mesh_sent_in_millimetres_is_put_into_a_bowl_by_a_motion_a_real_arm_may_make(
    client, plan_it, carry_out, shelf, request_body
):
    answer = uploaded(client, wedge(1000.0), name="bracket", scale=0.001, density=400)
    assert answer.status_code == 201, answer.text
    asset = answer.json()
    assert asset["size"] == pytest.approx([0.06, 0.04, 0.04], abs=1e-4)
    assert asset["parts"] > 1
    assert asset["graspable"]
    assert asset["mass"] == pytest.approx(400 * 64e-6, rel=0.1)
    scene = {"objects": [{"name": "banana", "kind": asset["kind"]}, {"name": "bowl"}]}
    plan = client.post("/plans", json={**request_body, "scene": scene}).json()
    plan_it(plan["id"])
    [execution_id] = client.get(f"/plans/{plan['id']}").json()["executions"]
    carry_out(execution_id)
    execution = client.get(f"/executions/{execution_id}").json()
    assert execution["status"] == "succeeded", execution
    assert execution["scores"]["sr"] == 1.0, execution["scores"]
    kept = client.delete(f"/assets/{asset['id']}")
    assert kept.status_code == 409
    assert client.get(f"/executions/{execution_id}/recording").status_code == 200
    service = ["--service", str(client.base_url), "--url", "ws://127.0.0.1:9"]
    sent = CliRunner().invoke(main, ["robot", "send", execution_id, *service])
    assert sent.exit_code == 0, sent.output
    assert "checked, not sent" in sent.output
    lost = CliRunner().invoke(main, ["robot", "send", execution_id, *service, "--live"])
    assert lost.exit_code == 1
    assert "lost the robot" in lost.output


def test_the_same_mesh_is_the_same_asset_and_goes_when_nothing_names_it(client, shelf):
    sphere = trimesh.creation.icosphere(2, 0.02)
    first, again = uploaded(client, sphere, "obj"), uploaded(client, sphere, "obj")
    assert (first.status_code, again.status_code) == (201, 200)
    assert first.json()["id"] == again.json()["id"]
    assert [item["id"] for item in client.get("/assets").json()["items"]] == [first.json()["id"]]
    scene = {"objects": [{"name": "thing", "kind": first.json()["kind"]}]}
    assert client.post("/scenes/validate", json=scene).status_code == 200
    path = first.headers["location"]
    assert client.delete(path).status_code == 204
    assert client.get(path).status_code == 404
    refused = client.post("/scenes/validate", json=scene)
    assert refused.status_code == 422
    assert refused.json()["errors"][0]["field"] == "objects.0.kind"
    assert "GET /assets" in refused.json()["errors"][0]["message"]


def test_a_size_that_cannot_be_is_refused_with_the_unit_it_may_be_in(standing, problem_of):
    answer = standing.post("/assets", content=exported(wedge(1000.0)), headers=STL)
    [fault] = problem_of(answer, 422)["errors"]
    assert fault["field"] == "scale"
    assert "scale=0.001" in fault["message"]


def test_wrong_words_about_a_mesh_are_refused(standing, problem_of):
    data = exported(wedge())
    for query in ({"scale": 0}, {"density": 5}, {"up": "w"}, {"colour": "loud"}):
        answer = standing.post("/assets", content=data, headers=STL, params=query)
        [field] = query
        assert field in problem_of(answer, 422)["errors"][0]["field"]
    plain = standing.post("/assets", content=data, headers={"Content-Type": "text/plain"})
    assert problem_of(plain, 415)


def test_a_mesh_whose_turn_does_not_come_is_to_be_sent_again(standing, problem_of, monkeypatch):
    monkeypatch.setattr(upload, "TURN", 0.01)
    with upload.AT_ONCE:
        answer = uploaded(standing, wedge(), name="patient")
    problem = problem_of(answer, 503)
    assert problem["type"].endswith(":busy")
    assert "send this one again" in problem["detail"]
    assert int(answer.headers["Retry-After"]) > 0


def test_a_file_of_more_than_twenty_megabytes_is_refused_at_once(standing, problem_of):
    answer = standing.post("/assets", content=np.zeros(20_000_001, np.int8).tobytes(), headers=STL)
    assert problem_of(answer, 413)["errors"][0]["field"] == "body"


def test_a_body_of_ones_own_in_mjcf_is_put_into_a_bowl(
    client, plan_it, carry_out, shelf, request_body, problem_of
):
    body = (
        '<mujoco><worldbody><body><geom type="box" size="0.02 0.015 0.02" rgba="0 1 0 1" mass="0.03"/>'
        '<geom type="sphere" size="0.012" pos="0 0 0.03" mass="0.01"/></body></worldbody></mujoco>'
    )
    media = {"Content-Type": "application/xml"}
    answer = client.post("/assets", content=body, headers=media, params={"name": "pawn"})
    assert answer.status_code == 201, answer.text
    asset = answer.json()
    assert (asset["parts"], asset["graspable"]) == (2, True)
    assert asset["mass"] == pytest.approx(0.04)
    again = client.post("/assets", content=body, headers=media, params={"name": "pawn"})
    assert (again.status_code, again.json()["id"]) == (200, asset["id"])
    scene = {"objects": [{"name": "banana", "kind": asset["kind"]}, {"name": "bowl"}]}
    plan = client.post("/plans", json={**request_body, "scene": scene}).json()
    plan_it(plan["id"])
    [execution_id] = client.get(f"/plans/{plan['id']}").json()["executions"]
    carry_out(execution_id)
    execution = client.get(f"/executions/{execution_id}").json()
    assert execution["scores"]["sr"] == 1.0, execution
    spoilt = body.replace("<worldbody>", "<worldbody><light/>")
    refused = problem_of(client.post("/assets", content=spoilt, headers=media), 422)
    assert "<light>" in refused["errors"][0]["message"]
