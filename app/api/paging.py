"""Paging: a cursor says where the last part of a list ended."""

import json
from collections.abc import Callable, Sequence
from typing import Annotated, Protocol, TypeVar

from fastapi import Query, Response
from sqlalchemy.orm import Mapped

from app.api.schemas.base import Shown
from app.domain.errors import Fault, Refused

MAX_LIMIT = 100
MOST = 2**31 - 1
"""The highest number that a column of whole numbers takes in every database."""

Limit = Annotated[int, Query(ge=1, le=MAX_LIMIT, description="Entries of one part of the list.")]
Cursor = Annotated[
    str | None, Query(max_length=20, description="`next` of the part before; none for the first.")
]


def position(cursor: str | None) -> int | None:
    """The place a cursor names.

    Raises:
        Refused: it is none of ours.
    """
    if cursor is None:
        return None
    if not (cursor.isascii() and cursor.isdigit() and int(cursor) <= MOST):
        raise Refused(Fault(field="cursor", message="pass the `next` of the part before"))
    return int(cursor)


class Listed(Protocol):
    """A row of a table whose rows are listed by their order of arrival."""

    serial: Mapped[int]


Row = TypeVar("Row", bound=Listed)


def part(rows: Sequence[Row], limit: int, show: Callable[[Row], Shown]) -> Response:
    """The answer with the first ``limit`` of the rows; one row more says that the list goes on.

    Written once: a response model would be checked and written a second time.
    """
    items = ",".join(show(row).model_dump_json() for row in rows[:limit])
    following = str(rows[limit - 1].serial) if len(rows) > limit else None
    text = f'{{"items":[{items}],"next":{json.dumps(following)}}}'
    return Response(text, media_type="application/json")
