"""Suites: tasks as data, the shipped ones by name and others by their files."""

import json
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, fields, replace
from pathlib import Path
from typing import Any

from app.domain.errors import Fault, ProgPromptError, Refused, UnknownName
from app.domain.scene import Scene, SceneObject
from app.evaluation.generated import with_distractors
from app.evaluation.tasks import SuiteTask
from app.programs.conditions import parse_condition

FOLDER = Path(__file__).resolve().parents[2] / "static" / "suites"
SUFFIXES = (".jsonl", ".json")
_PLAIN = ("name", "category", "instruction", "seed", "variants", "decline", "length", "hold")


@dataclass(frozen=True, slots=True, kw_only=True)
class Suite:
    """Tasks that are measured together."""

    name: str
    tasks: tuple[SuiteTask, ...]

    def chosen(
        self,
        *,
        split: str = "all",
        categories: Sequence[str] = (),
        names: Sequence[str] = (),
        limit: int | None = None,
    ) -> "Suite":
        """The tasks of a split, of some categories or of some names, evenly thinned to a limit."""
        tasks = [
            task
            for task in self.tasks
            if split in ("all", task.split)
            and (not categories or task.category in categories)
            and (not names or task.name in names)
        ]
        if limit is not None and limit < len(tasks):
            tasks = [tasks[index * len(tasks) // limit] for index in range(limit)]
        return replace(self, tasks=tuple(tasks))


def suites() -> tuple[str, ...]:
    """Names of the shipped suites."""
    return tuple(sorted(path.stem for path in FOLDER.iterdir() if path.suffix in SUFFIXES))


def find_suite(name: str) -> Suite:
    """A shipped suite by its name.

    Raises:
        UnknownName: there is none of this name.
    """
    for suffix in SUFFIXES:
        path = FOLDER / f"{name}{suffix}"
        if name in suites() and path.exists():
            return read_suite(path)
    raise UnknownName("suite", name, suites())


def read_suite(path: Path) -> Suite:
    """The suite in a file: a JSON list of tasks, or one task a line.

    Raises:
        Refused: the file is no suite; the faults name their tasks.
    """
    try:
        text = path.read_text(encoding="utf-8")
        entries = (
            [json.loads(line) for line in text.splitlines() if line.strip()]
            if path.suffix == ".jsonl"
            else json.loads(text)
        )
    except (OSError, ValueError) as error:
        raise Refused(Fault(field="suite", message=f"{path} cannot be read: {error}")) from error
    tasks = tuple(task for index, entry in enumerate(entries) for task in _tasks(entry, index))
    names = [task.name for task in tasks]
    double = sorted({name for name in names if names.count(name) > 1})
    if double:
        message = f"several tasks are called {', '.join(double)}; a name is a task's key"
        raise Refused(Fault(field="suite", message=message))
    return Suite(name=path.stem, tasks=tasks)


def _tasks(entry: object, index: int) -> Iterator[SuiteTask]:
    """The task of an entry, or one for each number of distractors where it asks for that."""
    if not isinstance(entry, dict):
        raise Refused(Fault(field=f"tasks.{index}", message="an object is wanted"))
    try:
        if not entry.get("growing"):
            yield _task(entry)
            return
        for count in range(len(entry["distractors"]) + 1):
            yield _task(_with_first_distractors(entry, count))
    except (KeyError, TypeError, ValueError) as error:
        message = f"is no task ({type(error).__name__}: {error}); it needs name, scene, instruction"
        raise Refused(Fault(field=f"tasks.{index}", message=message)) from error
    except ProgPromptError as error:
        raise Refused(Fault(field=f"tasks.{index}", message=str(error))) from error


def _with_first_distractors(entry: dict[str, Any], count: int) -> dict[str, Any]:
    """The paper's robot tasks: the same task among ever more objects that do not belong to it."""
    shown = entry["distractors"][:count]
    return {
        **entry,
        "name": f"{entry['name']}, {count} distractor{'' if count == 1 else 's'}",
        "category": entry["name"],
        "distractors": shown,
        "objects": [*entry["objects"], *shown],
        "growing": False,
    }


def _task(entry: dict[str, Any]) -> SuiteTask:
    unknown = set(entry) - {field.name for field in fields(SuiteTask)} - _READ_APART
    if unknown:
        raise ValueError(f"unknown fields {', '.join(sorted(unknown))}")
    lists = {
        name: tuple(entry.get(name, ()))
        for name in ("goal", "truth", "distractors", "may_change", "order", "always")
    }
    core = entry.get("core_goal")
    for text in (*lists["goal"], *lists["order"], *lists["always"], *(core or ())):
        parse_condition(text)
    task = SuiteTask(
        scene=_scene(entry),
        core_goal=None if core is None else tuple(core),
        **lists,
        **{name: entry[name] for name in _PLAIN if name in entry},
    )
    generator = entry.get("generator")
    return with_distractors(task, **generator) if generator else task


_READ_APART = {"world", "objects", "generator", "growing"}


def _scene(entry: dict[str, Any]) -> Scene:
    """Objects may be named at the top of an entry where there is no more to say of them."""
    scene = entry.get("scene", {})
    actions = scene.get("actions")
    named = [{"name": name} for name in entry.get("objects", ())]
    return Scene(
        world=entry.get("world", "tabletop"),
        objects=tuple(_object(item) for item in (*scene.get("objects", ()), *named)),
        actions=None if actions is None else tuple(actions),
        environment=scene.get("environment"),
        robot=scene.get("robot"),
    )


def _object(item: dict[str, Any]) -> SceneObject:
    """Numbers of three as tuples; everything else as it stands."""
    given: dict[str, Any] = {
        name: tuple(value) if isinstance(value, list) else value for name, value in item.items()
    }
    return SceneObject(**given)
