"""BodyLimit: bodies of a reasonable size only."""

from starlette.exceptions import HTTPException
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from app.api.errors import Problem
from app.domain.errors import Fault

MAX_BODY = 1_000_000  # bytes
LARGER = {"/assets": 20_000_000}
"""Paths that take more, and how much [bytes]."""


class BodyLimit:
    """Refuses a body of too many bytes, whether it says its length or not."""

    def __init__(self, app: ASGIApp) -> None:
        self._app = app

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass the request on, counting."""
        if scope["type"] != "http":
            await self._app(scope, receive, send)
            return
        most = LARGER.get(scope["path"], MAX_BODY)
        declared = dict(scope["headers"]).get(b"content-length", b"0")
        if declared.isdigit() and int(declared) > most:
            await _refuse(most, scope, receive, send)
            return
        received = 0

        async def counted() -> Message:
            nonlocal received
            message = await receive()
            received += len(message.get("body", b""))
            if received > most:
                raise HTTPException(413, _too_large(most))
            return message

        await self._app(scope, counted, send)


def _too_large(most: int) -> str:
    return f"the body has more than {most} bytes"


async def _refuse(most: int, scope: Scope, receive: Receive, send: Send) -> None:
    fault = Fault(field="body", message=_too_large(most))
    await Problem(413, _too_large(most), faults=[fault])(scope, receive, send)
