"""The catalogue: worlds, robots, objects, actions, models and planners there are."""

from dataclasses import asdict
from typing import Annotated, Any

from fastapi import APIRouter, Query

from app.api.parts import Using
from app.api.schemas.base import Page
from app.domain.action import ActionSignature
from app.domain.errors import UnknownName
from app.domain.world import WorldDescription
from app.llm.models import catalogue
from app.planners import planners
from app.worlds import worlds

router = APIRouter(prefix="/catalog", tags=["catalogue"])

World = Annotated[str, Query(max_length=100, description="Name of the world.")]


@router.get("/worlds")
def list_worlds() -> Page:
    """The worlds a scene can name."""
    return _page(
        {
            "name": name,
            "actions": [action.name for action in world.actions],
            "default_actions": list(world.default_actions),
            "environments": list(world.environments()),
            "planner": world.planner,
            "moves": world.moves,
            "relations": world.relations,
        }
        for name, world in worlds.items()
    )


@router.get("/objects")
def list_objects(world: World = "tabletop") -> Page:
    """The object kinds of a world."""
    return _page(
        {
            "name": kind.name,
            "category": kind.category,
            "synonyms": list(kind.synonyms),
            "container": kind.container,
            "size": list(kind.size),
            "colour": kind.colour,
        }
        for kind in _world(world).catalogue()
    )


@router.get("/robots")
def list_robots(world: World = "tabletop") -> Page:
    """The robots a scene of a world can name; `default` marks the one that works unless it does."""
    return _page(asdict(robot) for robot in _world(world).robots)


@router.get("/actions")
def list_actions(world: World = "tabletop") -> Page:
    """The action primitives of a world."""
    return _page(_action(action) for action in _world(world).actions)


@router.get("/models")
def list_models(parts: Using) -> Page:
    """The language models a plan can name; `default` marks the one that most plans will use.

    The one with canned completions is among them where its file is configured.
    """
    default = parts.default_model
    if default == "default":
        default = planners[worlds["tabletop"].planner].model
    return _page(
        {
            "name": spec.name,
            "title": spec.title,
            "backend": spec.backend,
            "licence": spec.licence,
            "aliases": list(spec.aliases),
            "default": default in (spec.name, *spec.aliases),
        }
        for spec in catalogue(parts.llm)
        if spec.backend != "scripted" or parts.llm.scripted_file
    )


@router.get("/planners")
def list_planners() -> Page:
    """The planners a plan can name."""
    return _page(
        {"name": name, "meaning": _first_line(planner), "model": planner.model}
        for name, planner in sorted(planners.items())
    )


def _world(name: str) -> WorldDescription:
    if name not in worlds:
        raise UnknownName("world", name, worlds)
    return worlds[name]


def _action(action: ActionSignature) -> dict[str, Any]:
    return {
        "name": action.name,
        "parameters": [{"name": one.name, "role": one.role} for one in action.parameters],
        "meaning": action.meaning,
    }


def _first_line(planner: object) -> str:
    return (type(planner).__doc__ or "").strip().split("\n")[0]


def _page(entries: Any) -> Page:  # noqa: ANN401 - an iterable of JSON objects
    return Page(items=list(entries), next=None)
