"""Errors as problem documents (RFC 9457), and the one table of what is which HTTP status."""

import logging
import re
from collections.abc import Sequence
from http import HTTPStatus
from typing import Any

from fastapi import FastAPI, Request
from fastapi.exceptions import RequestValidationError
from fastapi.responses import JSONResponse
from starlette.exceptions import HTTPException

from app.api.known_fields import known_fields
from app.domain.errors import (
    Busy,
    Cancelled,
    Conflict,
    Fault,
    ModelError,
    NotThere,
    ProgPromptError,
    Refused,
)

STATUS: dict[type[ProgPromptError], HTTPStatus] = {
    Refused: HTTPStatus.UNPROCESSABLE_ENTITY,
    NotThere: HTTPStatus.NOT_FOUND,
    Conflict: HTTPStatus.CONFLICT,
    Cancelled: HTTPStatus.CONFLICT,
    Busy: HTTPStatus.SERVICE_UNAVAILABLE,
    ModelError: HTTPStatus.SERVICE_UNAVAILABLE,
    ProgPromptError: HTTPStatus.INTERNAL_SERVER_ERROR,
}
MAX_FAULTS = 50
"""So many are listed in ``errors``."""
FIRST = 3
"""So many are told in ``detail``."""
log = logging.getLogger(__name__)


class Problem(JSONResponse):
    """A problem document."""

    media_type = "application/problem+json"

    def __init__(
        self,
        status: int,
        detail: str,
        *,
        kind: str | None = None,
        faults: Sequence[Fault] = (),
        headers: dict[str, str] | None = None,
        **more: Any,  # noqa: ANN401 - members of the document
    ) -> None:
        """Say what is wrong, and in ``faults`` which fields are.

        Of many only the first are listed; ``errors_left_out`` is how many more there are then.
        """
        title = HTTPStatus(status).phrase
        if len(faults) > MAX_FAULTS:
            more["errors_left_out"] = len(faults) - MAX_FAULTS
        content: dict[str, Any] = {
            "type": f"urn:progprompt:problem:{kind or title.lower().replace(' ', '-')}",
            "title": title,
            "status": status,
            "detail": _plain(detail),
            "errors": [
                {"field": _plain(fault.field), "message": _plain(fault.message)}
                for fault in faults[:MAX_FAULTS]
            ],
            **more,
        }
        super().__init__(content, status_code=status, headers=headers)


def install(app: FastAPI) -> None:
    """Have every error answered by a problem document."""
    app.add_exception_handler(ProgPromptError, _on_ours)
    app.add_exception_handler(RequestValidationError, _on_invalid)
    app.add_exception_handler(HTTPException, _on_http)
    app.add_exception_handler(Exception, _on_unexpected)


def _on_ours(_request: Request, error: Exception) -> Problem:
    kind = type(error)
    status = next(STATUS[found] for found in kind.__mro__ if found in STATUS)
    faults = error.faults if isinstance(error, Refused) else ()
    detail = _told(faults) if faults else str(error)
    name = re.sub(r"(?<!^)(?=[A-Z])", "-", kind.__name__).lower()
    headers = {"Retry-After": str(error.retry_after)} if isinstance(error, Busy) else None
    return Problem(status, detail, kind=name, faults=faults, headers=headers)


def _on_invalid(request: Request, error: Exception) -> Problem:
    assert isinstance(error, RequestValidationError)
    found = error.errors()
    faults = [_fault(entry, request) for entry in found]
    if any(entry["type"] == "json_invalid" for entry in found):
        return Problem(400, "the body is not JSON", kind="malformed-json", faults=faults)
    kind = request.headers.get("content-type", "")
    if any(entry["loc"] == ("body",) for entry in found) and "json" not in kind:
        return Problem(415, "send JSON, with Content-Type: application/json", faults=faults)
    return Problem(422, _told(faults), kind="request-refused", faults=faults)


def _told(faults: Sequence[Fault]) -> str:
    told = "; ".join(f"{fault.field}: {fault.message}" for fault in faults[:FIRST])
    return f"{told}; and {len(faults) - FIRST} more" if len(faults) > FIRST else told


def _fault(entry: dict[str, Any], request: Request) -> Fault:
    """A finding of pydantic; the place it was found in goes without ``body`` or ``query``."""
    place = [str(part) for part in entry["loc"][1:]]
    message = str(entry["msg"])
    if entry["type"] == "json_invalid":
        return Fault(field="body", message=f"not JSON at character {place[0]}: {message}")
    if entry["type"] == "extra_forbidden" and (known := known_fields(request, entry["loc"][1:-1])):
        message = f"is not known here; known are {', '.join(known)}"
    if entry["type"] == "value_error":
        named, _, rest = message.removeprefix("Value error, ").partition(": ")
        place, message = ([*place, named], rest) if rest else (place, named)
    return Fault(field=".".join(place) or "body", message=message)


def _on_http(_request: Request, error: Exception) -> Problem:
    assert isinstance(error, HTTPException)
    headers = dict(error.headers) if error.headers else None
    faults = ()
    if error.status_code == HTTPStatus.BAD_REQUEST:
        faults = (Fault(field="body", message=str(error.detail)),)
    return Problem(error.status_code, str(error.detail), faults=faults, headers=headers)


def _on_unexpected(_request: Request, error: Exception) -> Problem:
    log.error("unexpected error", exc_info=error)
    return Problem(500, f"something went wrong inside: {type(error).__name__}")


def _plain(text: str) -> str:
    """The text without what UTF-8 cannot carry (lone surrogates of a stranger's JSON)."""
    return text.encode("utf-8", "backslashreplace").decode("utf-8")
