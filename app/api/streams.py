"""Server-Sent Events: the events of a plan or an execution, as they are written down."""

import asyncio
import json
import time
from collections.abc import AsyncIterator, Callable, Iterable
from typing import Any

from fastapi.responses import Response, StreamingResponse
from starlette.concurrency import run_in_threadpool

from app.api.schemas.trace import event_view
from app.storage import events
from app.storage.database import Database
from app.storage.events import EventRow

LOOK_INTERVAL = 0.05  # [s] between looks for new events, however many streams are open
CHECK_INTERVAL = 0.3  # [s] between looks whether the owner has ended
RETRY_INTERVAL = 1000  # [ms] until a client whose connection broke comes back
HEARTBEAT_INTERVAL = 10.0  # [s] between comments that keep an idle connection open

Ending = dict[str, Any] | None
Read = Callable[[int], tuple[Ending, list[EventRow]]]
"""Reads what came after a sequence number, and how the owner ended if it has."""


class EventTail:
    """Wakes the open streams when an event has been written, by whichever process."""

    def __init__(self, database: Database) -> None:
        self._database = database
        self._news = asyncio.Event()
        self._waiting = 0
        self._newest = -1
        self._watcher: asyncio.Task[None] | None = None

    def ticket(self) -> asyncio.Event:
        """To be taken before reading, so that what is written meanwhile is not missed."""
        return self._news

    async def wait(self, ticket: asyncio.Event) -> None:
        """Until something was written since the ticket was taken, or it is time to check."""
        self._waiting += 1
        if self._watcher is None or self._watcher.done():
            self._watcher = asyncio.create_task(self._watch())
        try:
            async with asyncio.timeout(CHECK_INTERVAL):
                await ticket.wait()
        except TimeoutError:
            pass
        finally:
            self._waiting -= 1

    async def _watch(self) -> None:
        while self._waiting:
            newest = await run_in_threadpool(self._look)
            if newest != self._newest:
                self._newest = newest
                news, self._news = self._news, asyncio.Event()
                news.set()
            await asyncio.sleep(LOOK_INTERVAL)

    def _look(self) -> int:
        with self._database.reading() as session:
            return events.newest(session)


async def event_stream(tail: EventTail, read: Read, last_event_id: str | None) -> Response:
    """The response that follows an owner's events until it has ended.

    Every message carries its sequence number as ``id``, so ``Last-Event-ID`` resumes after it.
    The last message is of type ``end`` and tells the status. To a browser that comes back after
    that, the answer is 204, which is what makes an ``EventSource`` stop.
    """
    last = _number(last_event_id)
    ending, rows = await run_in_threadpool(read, last)
    if last >= 0 and ending is not None and not rows:
        return Response(status_code=204)
    return StreamingResponse(
        _follow(tail, read, last),
        media_type="text/event-stream",
        headers={"Cache-Control": "no-store", "X-Accel-Buffering": "no"},
    )


async def _follow(tail: EventTail, read: Read, last: int) -> AsyncIterator[str]:
    yield f"retry: {RETRY_INTERVAL}\n\n"
    told_at = time.monotonic()
    while True:
        ticket = tail.ticket()
        ending, rows = await run_in_threadpool(read, last)
        if rows:
            last, told_at = rows[-1].sequence, time.monotonic()
            yield "".join(_messages(rows))
        elif ending is not None:
            yield f"event: end\ndata: {json.dumps({'kind': 'end', **ending})}\n\n"
            return
        else:
            if time.monotonic() - told_at > HEARTBEAT_INTERVAL:
                told_at = time.monotonic()
                yield ": still there\n\n"
            await tail.wait(ticket)


def _messages(rows: Iterable[EventRow]) -> Iterable[str]:
    for row in rows:
        yield f"id: {row.sequence}\ndata: {json.dumps(event_view(row))}\n\n"


def _number(last_event_id: str | None) -> int:
    text = (last_event_id or "").strip()
    return int(text) if text.isdecimal() and len(text) < 10 else -1
