"""BodyLimit: bodies of a reasonable size only."""

from starlette.exceptions import HTTPException
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from app.api.errors import Problem
from app.domain.errors import Fault

MAX_BODY = 1_000_000  # bytes
TOO_LARGE = f"the body has more than {MAX_BODY} bytes"


class BodyLimit:
    """Refuses a body of more than ``MAX_BODY`` bytes, whether it says its length or not."""

    def __init__(self, app: ASGIApp) -> None:
        self._app = app

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass the request on, counting."""
        if scope["type"] != "http":
            await self._app(scope, receive, send)
            return
        declared = dict(scope["headers"]).get(b"content-length", b"0")
        if declared.isdigit() and int(declared) > MAX_BODY:
            await _refuse(scope, receive, send)
            return
        received = 0

        async def counted() -> Message:
            nonlocal received
            message = await receive()
            received += len(message.get("body", b""))
            if received > MAX_BODY:
                raise HTTPException(413, TOO_LARGE)
            return message

        await self._app(scope, counted, send)


async def _refuse(scope: Scope, receive: Receive, send: Send) -> None:
    fault = Fault(field="body", message=TOO_LARGE)
    await Problem(413, TOO_LARGE, faults=[fault])(scope, receive, send)
