"""HouseholdHomes: a folder with the homes that a scene may name, one JSON file each."""

import json
from functools import lru_cache
from pathlib import Path

from app.domain.errors import Fault, SceneRefused
from app.domain.scene import Scene
from app.domain.world import ObjectKind
from app.worlds.simulators.household_document import Document, read_graph
from app.worlds.simulators.household_graph import HouseholdGraph
from app.worlds.simulators.household_things import kind

SHIPPED = Path(__file__).resolve().parents[3] / "static" / "homes"
FIRST = "env0"
"""The home of a scene that names none."""


class HouseholdHomes:
    """The homes of one folder."""

    def __init__(self, folder: Path = SHIPPED) -> None:
        """Take those that ship with the product, or these."""
        self.folder = folder

    def names(self) -> tuple[str, ...]:
        """What ``environment`` of a scene may be."""
        return tuple(sorted(file.stem for file in self.folder.glob("env*.json")))

    def graph(self, scene: Scene) -> HouseholdGraph:
        """The home of the scene as it is at first.

        Raises:
            SceneRefused: it names no home, or its own graph is none.
        """
        if scene.graph is not None:
            if scene.environment is not None:
                message = "is given beside a graph; give one of the two"
                raise SceneRefused(Fault(field="scene.environment", message=message))
            return read_graph(json.loads(scene.graph))
        name = scene.environment or FIRST
        if name not in self.names():
            message = f"there is no home {name[:80]!r}; there is: {', '.join(self.names())}"
            raise SceneRefused(Fault(field="scene.environment", message=message))
        return read_graph(_document(self.folder / f"{name}.json"), field="scene.environment")

    def catalogue(self) -> tuple[ObjectKind, ...]:
        """Every class of thing in any of the homes, with its bounding box."""
        found: dict[str, ObjectKind] = {}
        for name in self.names():
            graph = read_graph(_document(self.folder / f"{name}.json"))
            for node in graph.nodes.values():
                if node.name not in found and node is not graph.agent:
                    found[node.name] = kind(node)
        return tuple(found[name] for name in sorted(found))


@lru_cache(maxsize=8)
def _document(file: Path) -> Document:
    return json.loads(file.read_text(encoding="utf-8"))
