"""The HTTP application: every module of ``resources`` with a ``router`` is mounted."""

import importlib
import pkgutil
from collections import Counter
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from pathlib import Path

from fastapi import FastAPI
from fastapi.responses import FileResponse, Response
from fastapi.staticfiles import StaticFiles
from fastapi_offline import FastAPIOffline
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from app.api import resources
from app.api.errors import install
from app.api.limits import BodyLimit
from app.api.parts import Parts
from app.view.viewer import Viewer

STATIC = Path(__file__).parents[2] / "static"
DESCRIPTION = "A sentence becomes a situated robot program, is carried out in physics, and scored."


def create_app(parts: Parts, viewer: Viewer | None = None) -> FastAPI:
    """The application over its parts."""

    @asynccontextmanager
    async def lifespan(_app: FastAPI) -> AsyncIterator[None]:
        yield
        parts.jobs.close()
        parts.database.close()

    # FastAPI's own pages of documentation fetch their scripts from the net.
    app = FastAPIOffline(
        title="ProgPrompt", version="1", description=DESCRIPTION, lifespan=lifespan
    )
    app.state.parts = parts
    app.state.viewer = viewer
    app.state.requests = Counter()
    install(app)
    app.add_middleware(BodyLimit)
    app.add_middleware(RequestCount, requests=app.state.requests)
    for module in pkgutil.iter_modules(resources.__path__):
        app.include_router(importlib.import_module(f"{resources.__name__}.{module.name}").router)
    if STATIC.is_dir():
        app.mount("/static", StaticFiles(directory=STATIC), name="static")

        @app.get("/", include_in_schema=False)
        def index() -> Response:
            return FileResponse(STATIC / "index.html")

    return app


class RequestCount:
    """Counts the answers by method, route and status."""

    def __init__(self, app: ASGIApp, requests: Counter[tuple[str, str, int]]) -> None:
        self._app = app
        self._requests = requests

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass the request on, noting the status of its answer."""
        answered = False

        def count(status: int) -> None:
            nonlocal answered
            answered = True
            route = getattr(scope.get("route"), "path", "other")
            self._requests[scope["method"], route, status] += 1

        async def noted(message: Message) -> None:
            if message["type"] == "http.response.start":
                count(message["status"])
            await send(message)

        try:
            await self._app(scope, receive, noted)
        except Exception:
            # What nobody expected is answered further out, with 500.
            if scope["type"] == "http" and not answered:
                count(500)
            raise
