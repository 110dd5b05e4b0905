"""Paging: a cursor says where the last part of a list ended."""

from typing import Annotated

from fastapi import Query

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
