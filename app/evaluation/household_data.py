"""The paper's household tasks, read from a folder of theirs; nothing of it is kept.

The folder holds ``env0.json`` … and ``tasks_*.json``: the official graphs, instructions, recorded
action sequences and goals. Its licence allows research and evaluation only.
"""

import json
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any, Literal

from app.domain.condition import Relation
from app.domain.errors import Fault, Refused
from app.domain.scene import Scene
from app.evaluation.suites import Suite
from app.evaluation.tasks import SuiteTask
from app.programs.conditions import print_condition
from app.worlds.simulators.household_goals import OF_ONE, OF_TWO
from app.worlds.simulators.household_graph import HANDS

Part = Literal["test", "train"]
PARTS: dict[Part, dict[int, str]] = {
    "test": {0: "tasks_test_unseen.json", 1: "tasks_env1.json", 2: "tasks_env2.json"},
    "train": {0: "tasks_train.json"},
}
"""The paper's ten tasks in each environment; and the 35 that its example programs come from."""
NAMES: dict[Part, str] = {"test": "paper-household", "train": "paper-household-train"}
AGENT = 1
"""Id of the agent in every graph of theirs."""
_CALL = re.compile(r"\[(\w+)\]((?: <[^>]+> \(\d+\))*)")
_NAME = re.compile(r"<([^>]+)>")


def read_household(folder: Path, part: Part = "test") -> Suite:
    """The paper's 30 tasks, 10 in each environment, from the official start; or those to train on.

    Names begin with the environment, since several tasks come in more than one.

    Raises:
        Refused: the folder does not hold them.
    """
    try:
        read = (task for place, file in PARTS[part].items() for task in _part(folder, place, file))
        tasks = tuple({task.name: task for task in read}.values())
    except (OSError, ValueError, KeyError) as error:
        message = f"{folder} does not hold the paper's tasks: {error}"
        raise Refused(Fault(field="household-data", message=message)) from error
    return Suite(name=NAMES[part], tasks=tasks)


def _part(folder: Path, place: int, part: str) -> Iterator[SuiteTask]:
    home = json.loads((folder / f"env{place}.json").read_text(encoding="utf-8"))
    for entry in json.loads((folder / part).read_text(encoding="utf-8")):
        yield _task(entry, place, home)


def _task(entry: dict[str, Any], place: int, home: dict[str, Any]) -> SuiteTask:
    near = entry["agent_close"]
    close = [[AGENT, "CLOSE", each] for each in near] + [[each, "CLOSE", AGENT] for each in near]
    graph = {
        "nodes": home["nodes"],
        "edges": [*home["edges"], *close],
        "agent_room": home["agent_room"],
    }
    goal = (*entry["goal_relations"], *entry["goal_states"])
    core = _conditions(entry["core_goals"])
    return SuiteTask(
        name=f"env{place}: {entry['task']}",
        category="paper",
        scene=Scene(world="household", graph=json.dumps(graph)),
        instruction=entry["task"],
        goal=_conditions(goal),
        core_goal=core or None,
        truth=tuple(_call(line) for line in entry["actions"]),
        place=f"env{place}",
    )


def plain_name(name: str) -> str:
    """The task's name as the paper prints it."""
    return name.partition(": ")[2] or name


def _call(line: str) -> str:
    """``[putin] <apple> (438) <fridge> (305)`` as a call over classes of things."""
    found = _CALL.fullmatch(line.strip())
    if found is None:
        raise ValueError(f"{line!r} is no recorded action")
    names = ", ".join(f"'{name}'" for name in _NAME.findall(found[2]))
    return f"{found[1].lower()}({names})"


def _conditions(facts: list[str] | tuple[str, ...]) -> tuple[str, ...]:
    told = (relation for fact in facts if (relation := _relation(fact.split())))
    return tuple(dict.fromkeys(map(print_condition, told)))


def _relation(words: list[str]) -> Relation | None:
    if len(words) == 2:
        return Relation(OF_ONE[words[1]], (words[0],)) if words[1] in OF_ONE else None
    source, name, target = words
    if name in HANDS:
        return Relation("held", (target,))
    return Relation(OF_TWO[name], (source, target)) if name in OF_TWO else None
