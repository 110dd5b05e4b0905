"""The one gate to HTTP: time limits, retries, and foreign errors turned into ours."""

import json
import random
import re
import time
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from email.utils import parsedate_to_datetime
from typing import Any

import httpx

from app.domain.errors import CompletionFailed, ModelUnavailable

RETRIED = frozenset({408, 409, 425, 429, 500, 502, 503, 504, 529})
"""Answers after which the same request may well succeed."""
REMEDIES = {
    429: "the rate limit or the quota is used up: wait, or have it raised",
    503: "the service is overloaded: try again later, or another model",
    529: "the service is overloaded: try again later, or another model",
}
LONGEST_WAIT = 30.0
"""Between two attempts, whatever the other side asks for [s]."""

_TOO_LONG = re.compile(r"context (length|window|size)|too long|too many (input )?tokens", re.I)


@dataclass(frozen=True, slots=True, kw_only=True)
class Patience:
    """How long to wait for the other side, and how often to ask again."""

    connect: float = 5.0
    """For the connection [s]."""
    read: float = 120.0
    """Between two pieces of an answer [s]."""
    attempts: int = 4
    first_wait: float = 0.5
    """Before the second attempt; doubled before each further one [s]."""
    jitter: float = 0.5
    """By what share of it a wait is lengthened at most, at random: clients do not come all at once."""


class Transport:
    """Requests to one base URL."""

    def __init__(
        self,
        base_url: str,
        *,
        headers: Mapping[str, str] | None = None,
        patience: Patience | None = None,
        transport: httpx.BaseTransport | None = None,
        sleep: Callable[[float], None] = time.sleep,
    ) -> None:
        """Get ready; nothing is sent yet.

        Args:
            base_url: What the paths below are relative to.
            headers: Sent with every request: the key, in the form that the service wants.
            patience: Time limits and retries.
            transport: What carries the requests, where it is not the network.
            sleep: Waits between attempts [s].
        """
        self._patience = patience or Patience()
        self._sleep = sleep
        self._place = base_url
        limits = httpx.Timeout(self._patience.read, connect=self._patience.connect)
        with self._gate():
            self._client = httpx.Client(
                base_url=base_url,
                headers=headers,
                timeout=limits,
                transport=transport,
            )
        self._place = self._client.base_url.netloc.decode() or base_url

    def close(self) -> None:
        """Let go of the connections."""
        self._client.close()

    def post(self, path: str, body: Mapping[str, object]) -> dict[str, Any]:
        """Send JSON, get a JSON object.

        Raises:
            ModelUnavailable: it cannot be reached, or refuses us.
            CompletionFailed: it refuses this request, or answers with something else.
        """
        with self.stream("POST", path, body=body) as response:
            response.read()
            return json_object(response.text)

    @contextmanager
    def stream(
        self,
        method: str,
        path: str,
        *,
        body: Mapping[str, object] | None = None,
        headers: Mapping[str, str] | None = None,
        redirects: bool = False,
    ) -> Iterator[httpx.Response]:
        """The answer, successful, to be read piece by piece.

        With ``redirects`` it may come from elsewhere, and then the headers go there: only for
        requests without a key.

        Raises:
            ModelUnavailable: it cannot be reached, refuses us, or breaks off while it is read.
            CompletionFailed: it refuses this request.
        """
        with self._gate():
            request = self._client.build_request(method, path, json=body, headers=headers)
            response = self._send(request, redirects)
            try:
                yield response
            finally:
                response.close()

    def _send(self, request: httpx.Request, redirects: bool) -> httpx.Response:
        wait = self._patience.first_wait
        for attempts_left in reversed(range(self._patience.attempts)):
            try:
                response = self._client.send(request, stream=True, follow_redirects=redirects)
            except (httpx.ConnectError, httpx.ConnectTimeout, httpx.RemoteProtocolError):
                if not attempts_left:
                    raise
                asked = 0.0
            else:
                if response.status_code not in RETRIED or not attempts_left:
                    return self._checked(response)
                asked = _retry_after(response)
                response.close()
            wait_now = max(wait * (1 + self._patience.jitter * random.random()), asked)
            self._sleep(min(wait_now, LONGEST_WAIT))
            wait *= 2
        raise AssertionError("at least one attempt is made")

    def _checked(self, response: httpx.Response) -> httpx.Response:
        if response.is_success:
            return response
        response.read()
        status, said = response.status_code, f"{self._place} says: {_message(response)}"
        if status in (401, 403):
            raise ModelUnavailable(f"the key was refused ({status}); set a valid one. {said}")
        if response.has_redirect_location:
            moved = response.url.join(response.headers["Location"])
            raise ModelUnavailable(f"{self._place} has moved to {moved}; set that address")
        if status == 404:
            raise ModelUnavailable(f"no such model or address (404): {response.url}. {said}")
        if status in RETRIED:
            todo = REMEDIES.get(status, "try again later")
            raise ModelUnavailable(f"still {status} after several attempts; {todo}. {said}")
        if status == 413 or _TOO_LONG.search(said):
            todo = "use fewer objects or examples, or a model that takes more"
            raise CompletionFailed(f"the prompt is too long ({status}); {todo}. {said}")
        raise CompletionFailed(f"the request was refused ({status}). {said}")

    @contextmanager
    def _gate(self) -> Iterator[None]:
        try:
            yield
        except httpx.ConnectTimeout as error:
            limit = self._patience.connect
            raise ModelUnavailable(f"{self._place} gave no connection in {limit:g} s") from error
        except httpx.TimeoutException as error:
            limit = self._patience.read
            raise ModelUnavailable(f"{self._place} sent nothing for {limit:g} s") from error
        except (httpx.ReadError, httpx.RemoteProtocolError) as error:
            raise ModelUnavailable(f"{self._place} broke off: {error}; ask again") from error
        except (httpx.HTTPError, httpx.InvalidURL, httpx.StreamError) as error:
            raise ModelUnavailable(f"{self._place} could not be reached: {error}") from error


def json_object(text: str) -> dict[str, Any]:
    """The text as a JSON object.

    Raises:
        CompletionFailed: it is none.
    """
    try:
        value = json.loads(text)
    except ValueError as error:
        raise CompletionFailed(f"the answer is not JSON: {text[:200]!r}") from error
    if not isinstance(value, dict):
        raise CompletionFailed(f"the answer is not a JSON object: {text[:200]!r}")
    return value


def sent_events(response: httpx.Response) -> Iterator[dict[str, Any]]:
    """The objects in a stream of server-sent events; one ``{}`` where it says ``[DONE]``.

    Raises:
        CompletionFailed: one is not a JSON object.
    """
    for line in response.iter_lines():
        data = line.removeprefix("data:").strip()
        if line.startswith("data:") and data:
            yield {} if data == "[DONE]" else json_object(data)


def _message(response: httpx.Response) -> str:
    """What the other side says, from the shapes in use: ``{"error": {"message": …}}`` or text."""
    try:
        said = response.json()
        error = said["error"]
        return str(error["message"] if isinstance(error, dict) else error)[:500]
    except (ValueError, KeyError, TypeError):
        return response.text.strip()[:200] or response.reason_phrase


def _retry_after(response: httpx.Response) -> float:
    """The pause it asks for, in seconds or as the date when it ends [s]."""
    said = response.headers.get("Retry-After", "0")
    try:
        return max(0.0, float(said))
    except ValueError:
        pass
    try:
        return max(0.0, parsedate_to_datetime(said).timestamp() - time.time())
    except ValueError:
        return 0.0
