"""Known fields: what an object of a request may have where something unknown was given."""

from collections.abc import Iterator, Sequence
from typing import get_args

from fastapi import Request
from pydantic import BaseModel


def known_fields(request: Request, place: Sequence[str | int]) -> tuple[str, ...]:
    """The fields of the object at a place of the body; none where it could be of several kinds."""
    body = getattr(request.scope.get("route"), "body_field", None)
    found = _models(body.field_info.annotation) if body is not None else []
    for part in place:
        fields = found[0].model_fields if len(found) == 1 else {}
        if isinstance(part, str):
            found = _models(fields[part].annotation) if part in fields else []
    return tuple(found[0].model_fields) if len(found) == 1 else ()


def _models(kind: object) -> list[type[BaseModel]]:
    return list(dict.fromkeys(_within(kind)))


def _within(kind: object) -> Iterator[type[BaseModel]]:
    if isinstance(kind, type) and issubclass(kind, BaseModel):
        yield kind
    for part in get_args(kind):
        yield from _within(part)
