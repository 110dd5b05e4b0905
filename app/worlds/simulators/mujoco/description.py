"""What a client left open of its objects, places apart: kind, category, colour, size, yaw."""

import difflib
import math
import unicodedata
from dataclasses import replace

import numpy as np

from app.domain.asset import ASSET
from app.domain.errors import Fault
from app.domain.scene import SceneObject
from app.worlds.simulators.mujoco.colours import parse_colour
from app.worlds.simulators.mujoco.kind import Kind
from app.worlds.simulators.mujoco.matching import colour_in
from app.worlds.simulators.mujoco.objects import kinds, match, vocabulary

MAX_CHARACTERS = 100
_SIZES = 1
"""Keeps the stream of random numbers for sizes apart from others of the same seed."""


def describe(item: SceneObject, seed: int, index: int) -> tuple[SceneObject, list[Fault]]:
    """The object with all but its place filled in, and what is wrong with what was given.

    Args:
        item: as the client described it.
        seed: of the scene; together with the index it decides a size that is not given.
        index: of the object in its scene; faults carry it in their field.
    """
    where = f"scene.objects.{index}"
    faults = [*_name_faults(item, where), *_category_faults(item, where)]
    kind, found = _kind_of(item, where)
    faults += found
    if item.yaw is not None and not math.isfinite(item.yaw):
        faults.append(Fault(field=f"{where}.yaw", message="is no number; give radians, like 1.57"))
    if item.colour is not None and parse_colour(item.colour) is None:
        message = f"{item.colour[:40]!r} is no colour; give a CSS name like 'red', or '#d62828'"
        faults.append(Fault(field=f"{where}.colour", message=message))
    if item.size is not None and (message := kind.size_fault(item.size)):
        faults.append(Fault(field=f"{where}.size", message=message))
    random = np.random.default_rng([seed, _SIZES, index])
    described = replace(
        item,
        kind=kind.name,
        category=item.category or kind.category,
        colour=item.colour or colour_in(item.name) or kind.colour,
        size=item.size or kind.draw_size(random),
        container=kind.container,
    )
    return described, faults


def _kind_of(item: SceneObject, where: str) -> tuple[Kind, list[Fault]]:
    if item.kind is None:
        return kinds[match(item.name[:MAX_CHARACTERS], container=item.container)], []
    asked = item.kind[:MAX_CHARACTERS]
    name = asked if asked in kinds else vocabulary().get(asked.lower().replace("_", " "))
    if name is None:
        near = difflib.get_close_matches(asked.lower(), kinds, 3, 0.5) or list(kinds)
        message = f"there is no object kind {asked[:40]!r}; there is {', '.join(near)}"
        if asked.startswith(ASSET):
            message = f"there is no {asked[:40]!r}; GET /assets lists what there is"
        return kinds[match(asked)], [Fault(field=f"{where}.kind", message=message)]
    kind = kinds[name]
    if item.container and not kind.container:
        holders = ", ".join(known for known in kinds if kinds[known].container)
        message = f"a {name} holds nothing; leave it out, or choose a kind that does: {holders}"
        return kind, [Fault(field=f"{where}.container", message=message)]
    return kind, []


def _name_faults(item: SceneObject, where: str) -> list[Fault]:
    message = _text_fault(item.name)
    return [Fault(field=f"{where}.name", message=message)] if message else []


def _category_faults(item: SceneObject, where: str) -> list[Fault]:
    message = None if item.category is None else _text_fault(item.category)
    return [Fault(field=f"{where}.category", message=message)] if message else []


def _text_fault(text: str) -> str | None:
    if not text.strip():
        return "is empty; give a word or a few, like 'soup can'"
    if len(text) > MAX_CHARACTERS:
        return f"has {len(text)} characters; at most {MAX_CHARACTERS} are taken"
    if any(unicodedata.category(character) in ("Cc", "Cs", "Co", "Cn") for character in text):
        return "has control or unassigned characters; plain text is wanted"
    return None
