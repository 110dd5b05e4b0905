import json
from collections import Counter

import pytest

from app.worlds.simulators.household_document import read_graph
from app.worlds.simulators.household_graph import BUILT_CATEGORIES
from app.worlds.simulators.household_homes import SHIPPED

HOMES = sorted(SHIPPED.glob("*.json"))


@pytest.fixture(params=HOMES, ids=lambda file: file.stem)
def document(request):
    return json.loads(request.param.read_text())


def test_there_are_the_three_environments():
    assert [file.stem for file in HOMES] == ["env0", "env1", "env2"]


def test_a_home_is_read_without_fault_and_has_about_115_things(document):
    graph = read_graph(document)
    things = [n for n in graph.nodes.values() if n.category not in BUILT_CATEGORIES]
    assert 105 <= len(things) <= 150


def test_every_node_has_a_box_that_is_no_point(document):
    for node in document["nodes"]:
        assert all(side > 0 for side in node["bounding_box"]["size"]), node["class_name"]


def test_everything_is_in_one_room_and_within_its_walls(document):
    graph = read_graph(document)
    for node in graph.nodes.values():
        rooms = [each for each in graph.targets(node, "INSIDE") if each.is_room]
        assert node.is_room or len(rooms) == 1, node.name
        if not node.is_room:
            room = rooms[0].box
            assert room is not None
            assert node.box is not None
            for axis in (0, 2):
                assert abs(node.box.centre[axis] - room.centre[axis]) <= room.size[axis] / 2, (
                    node.name
                )


def test_rooms_do_not_overlap(document):
    graph = read_graph(document)
    rooms = [node.box for node in graph.nodes.values() if node.is_room and node.box]
    for index, one in enumerate(rooms):
        for other in rooms[:index]:
            apart = [
                abs(one.centre[k] - other.centre[k]) >= (one.size[k] + other.size[k]) / 2 - 1e-6
                for k in (0, 2)
            ]
            assert any(apart)


def test_doors_lead_to_every_room(document):
    graph = read_graph(document)
    rooms = {node.id for node in graph.nodes.values() if node.is_room}
    here = graph.room_of(graph.agent)
    assert here is not None
    reached, waiting = set(), [here.id]
    while waiting:
        room = waiting.pop()
        reached.add(room)
        for door in graph.named("door"):
            ends = graph.ids(door, "BETWEEN")
            waiting += [end for end in ends if room in ends and end not in reached]
    assert reached == rooms


def test_what_can_be_taken_is_in_or_on_something_that_holds_it(document):
    graph = read_graph(document)
    for node in graph.nodes.values():
        for support in graph.targets(node, "ON"):
            fits = {"SURFACES", "CONTAINERS", "SITTABLE"} & support.properties
            assert fits, (node.name, support.name)
        for around in graph.targets(node, "INSIDE"):
            fits = around.is_room or {"CONTAINERS", "RECIPIENT"} & around.properties
            assert fits, (node.name, around.name)


def test_what_opens_is_open_or_closed_and_what_has_a_switch_on_or_off(document):
    graph = read_graph(document)
    for node in graph.nodes.values():
        for name, states in (("CAN_OPEN", {"OPEN", "CLOSED"}), ("HAS_SWITCH", {"ON", "OFF"})):
            assert len(states & node.states) == (name in node.properties), node.name


def test_all_of_a_class_are_alike(document):
    kinds = {(n["class_name"], n["category"], tuple(n["properties"])) for n in document["nodes"]}
    assert max(Counter(name for name, _, _ in kinds).values()) == 1
