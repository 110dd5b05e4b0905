"""The paper's recorded sequences and final graphs; runs where PROGPROMPT_VIRTUALHOME leads to them.

The folder holds ``env*.json`` and ``tasks_*.json``; with the release's own ``final_*.json`` (one
graph a line, in the order of the tasks) beside them, final graphs are compared node by node.
"""

import json
import os
from pathlib import Path

import pytest

from app.worlds.actions.household_recording import replay
from app.worlds.simulators.household_document import read_graph
from app.worlds.simulators.household_goals import goal_facts

DATA = os.environ.get("PROGPROMPT_VIRTUALHOME", "")
pytestmark = pytest.mark.skipif(not DATA, reason="PROGPROMPT_VIRTUALHOME names no folder")

DERIVED = {"HEATED", "WASHED", "USED"}
"""The release added them only to what the agent saw, and to few of its recorded graphs."""
SNAPSHOT = ("call a friend", "wallphone ON")
"""The release's node for a phone in use is the one it copied while the phone was on."""
OFFICIAL, CLEAN = ("goal_relations", "goal_states"), ("clean_goal_relations", "clean_goal_states")


def tasks():
    files = sorted(Path(DATA).glob("tasks_*.json")) if DATA else []
    found = [(file.stem, index) for file in files for index in range(len(_read(file)))]
    return found or [("none", 0)]


def _read(file):
    return json.loads(Path(file).read_text())


def _folder():
    return Path(DATA)


def _told(facts):
    return {" ".join(fact) for fact in facts if fact[-1] not in DERIVED}


@pytest.mark.parametrize("start", ["official", "clean"])
@pytest.mark.parametrize(("suite", "index"), tasks())
def test_a_recorded_sequence_executes_and_changes_what_it_did(suite, index, start):
    task = _read(_folder() / f"{suite}.json")[index]
    document = _read(_folder() / f"env{task['env']}.json")
    close = task["agent_close"] if start == "official" else ()
    initial, final = (read_graph(document, close=close) for _ in range(2))
    assert replay(final, task["actions"]) == len(task["actions"])
    relations, states = OFFICIAL if start == "official" else CLEAN
    wanted = {fact for fact in task[relations] + task[states] if fact.split()[-1] not in DERIVED}
    assert _told(goal_facts(initial, final)) == wanted - (
        {SNAPSHOT[1]} if task["task"] == SNAPSHOT[0] else set()
    )


@pytest.mark.parametrize("environment", ["env1", "env2"])
def test_a_recorded_final_graph_is_reproduced(environment):
    """Of the first environment the recorded starts are lost, so that it cannot be asked."""
    recorded = _folder() / f"final_{environment}.json"
    if not recorded.exists():
        pytest.skip(f"there is no {recorded}")
    graphs = [json.loads(line) for line in recorded.read_text().splitlines() if line.strip()]
    for task, graph in zip(_read(_folder() / f"tasks_{environment}.json"), graphs, strict=True):
        final = read_graph(_read(_folder() / f"{environment}.json"), close=task["agent_close"])
        replay(final, task["actions"])
        edges = {(e["from_id"], e["relation_type"], e["to_id"]) for e in graph["edges"]}
        states = {(node["id"], state) for node in graph["nodes"] for state in node["states"]}
        assert set(final.edges()) == edges
        assert {(node.id, s) for node in final.nodes.values() for s in node.states} == states
