"""The service as the command line sees it: a few calls over HTTP, with errors people can read."""

import contextlib
import json
import time
from collections.abc import Iterator
from types import TracebackType
from typing import Any, Self

import click
import httpx
from httpx_sse import SSEError, connect_sse

RECONNECT_ATTEMPTS = 20
RECONNECT_PAUSE = 0.5  # [s]


class ServiceClient:
    """One service, at one URL."""

    def __init__(self, url: str) -> None:
        self.url = url.rstrip("/")
        self._http = httpx.Client(base_url=self.url, timeout=httpx.Timeout(30, connect=5))

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self._http.close()

    def create_plan(self, request: dict[str, Any]) -> dict[str, Any]:
        """``POST /plans``."""
        return self._answer("POST", "/plans", json=request)

    def cancel(self, path: str) -> None:
        """Stop what is under way at ``path``; nothing happens where it is over already."""
        with contextlib.suppress(click.ClickException):
            self._request("POST", f"{path}/cancel")

    def get(self, path: str) -> dict[str, Any]:
        """The resource at ``path``."""
        return self._answer("GET", path)

    def frames(self, execution_id: str) -> tuple[bytes, int]:
        """An execution's frames, little-endian float32, and how many numbers each has."""
        answer = self._request("GET", f"/executions/{execution_id}/frames")
        return answer.content, int(answer.headers["Frame-Width"])

    def readiness(self) -> tuple[bool, str]:
        """Whether a plan can be made, and if not, what it waits for."""
        try:
            answer = self._http.get("/readyz")
        except httpx.TransportError:
            return False, "waiting for the service to answer"
        content = answer.json()
        return answer.is_success, str(content.get("detail") or content.get("status", ""))

    def events(self, path: str, after: int = -1) -> Iterator[dict[str, Any]]:
        """Server-Sent Events until the stream ends of itself; a broken one is taken up again.

        Those up to the sequence number ``after`` are left out.
        """
        last, failures = str(after) if after >= 0 else "", 0
        while failures < RECONNECT_ATTEMPTS:
            headers = {"Last-Event-ID": last} if last else {}
            stream = connect_sse(self._http, "GET", path, headers=headers, timeout=60)
            try:
                with stream as source:
                    source.response.raise_for_status()
                    if source.response.status_code == httpx.codes.NO_CONTENT:
                        return
                    for event in source.iter_sse():
                        last, failures = event.id or last, 0
                        if event.data:
                            yield json.loads(event.data)
                return
            except (httpx.TransportError, SSEError):
                failures += 1
                time.sleep(RECONNECT_PAUSE)
            except httpx.HTTPStatusError as error:
                raise click.ClickException(f"{path}: {error}") from error
        raise click.ClickException(f"lost the service at {self.url} while following {path}")

    def _answer(self, method: str, path: str, **arguments: Any) -> dict[str, Any]:  # noqa: ANN401
        return self._request(method, path, **arguments).json()

    def _request(self, method: str, path: str, **arguments: Any) -> httpx.Response:  # noqa: ANN401
        try:
            answer = self._http.request(method, path, **arguments)
        except httpx.ConnectError as error:
            message = f"no service answers at {self.url}; start one with 'progprompt serve'"
            raise click.ClickException(message) from error
        except httpx.TransportError as error:
            raise click.ClickException(
                f"{method} {path}: {error or type(error).__name__}"
            ) from error
        if answer.is_error:
            raise click.ClickException(problem(answer))
        return answer


def problem(answer: httpx.Response) -> str:
    """A problem document (RFC 9457) in lines for people."""
    try:
        document = answer.json()
    except ValueError:
        return f"{answer.status_code} {answer.reason_phrase}"
    lines = [document.get("detail") or document.get("title") or str(answer.status_code)]
    told = (f"{fault.get('field')}: {fault.get('message')}" for fault in document.get("errors", ()))
    lines += [f"  {fault}" for fault in told if fault not in lines[0]]
    return "\n".join(lines)
