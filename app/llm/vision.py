"""Vision: objects found in pictures by a service that chats about them in the OpenAI protocol."""

import base64
import json
import re
from collections.abc import Sequence
from typing import Any

from app.domain.errors import CompletionFailed
from app.domain.sighting import Sighting
from app.llm.backend import Endpoint
from app.llm.transport import Transport

MOST_TOKENS = 4000
GRAIN = 1000
"""Places are told in so many parts of the picture's width and height."""
QUESTION = (
    "This picture is of a table, taken by a robot's camera. Find these objects in it: {names}. "
    "Answer with nothing but a JSON array that has one entry for each of them that you see: "
    '{{"name": the name as it stands above, "box": [left, top, right, bottom]}}, in thousandths '
    "of the picture's width and height from its top left corner. Where you cannot tell the box, "
    'give "point": [across, down] on the object instead. Leave out what you do not see.'
)
_ARRAY = re.compile(r"\[.*\]", re.DOTALL)


class VisionEndpoint:
    """One model that takes pictures."""

    def __init__(self, endpoint: Endpoint, transport: Transport | None = None) -> None:
        """Get ready; nothing is sent yet.

        Args:
            endpoint: where it is.
            transport: what carries the requests, where it is not the network.
        """
        headers = {"Authorization": f"Bearer {endpoint.key}"} if endpoint.key else {}
        base_url = endpoint.base_url.rstrip("/") + "/"
        self._model = endpoint.model
        self._transport = transport or Transport(base_url, headers=headers)

    def find(self, picture: bytes, names: Sequence[str]) -> tuple[Sighting, ...]:
        """Ask for all of them at once; see ``Finder``."""
        question = QUESTION.format(names=", ".join(json.dumps(name) for name in names))
        url = "data:image/png;base64," + base64.b64encode(picture).decode()
        content = [
            {"type": "text", "text": question},
            {"type": "image_url", "image_url": {"url": url}},
        ]
        answer = self._transport.post(
            "chat/completions",
            {
                "model": self._model,
                "max_tokens": MOST_TOKENS,
                "temperature": 0.0,
                "messages": [{"role": "user", "content": content}],
            },
        )
        return _sightings(_text(answer), names)


def _text(answer: dict[str, Any]) -> str:
    try:
        text = answer["choices"][0]["message"]["content"]
    except (KeyError, IndexError, TypeError) as error:
        raise CompletionFailed(f"the vision model gave no message: {str(answer)[:200]}") from error
    if not isinstance(text, str):
        raise CompletionFailed(f"the vision model gave no text: {str(text)[:200]}")
    return text


def _sightings(text: str, names: Sequence[str]) -> tuple[Sighting, ...]:
    """What the answer tells of the objects asked for; of others it may tell what it likes."""
    array = _ARRAY.search(text)
    try:
        entries = json.loads(array.group()) if array else None
    except ValueError:
        entries = None
    if not isinstance(entries, list) or not all(isinstance(entry, dict) for entry in entries):
        raise CompletionFailed(f"the vision model gave no JSON array of objects: {text[:200]!r}")
    found: dict[str, Sighting] = {}
    for entry in entries:
        name = entry.get("name")
        if name in names and name not in found:
            found[name] = _sighting(name, entry)
    return tuple(found.values())


def _sighting(name: str, entry: dict[str, Any]) -> Sighting:
    if entry.get("box") is not None:
        left, top, right, bottom = _shares(name, entry["box"], 4)
        if left < right and top < bottom:
            return Sighting(name=name, box=(left, top, right, bottom))
        raise CompletionFailed(f"the vision model gave {name!r} an empty box: {entry['box']}")
    across, down = _shares(name, entry.get("point"), 2)
    return Sighting(name=name, point=(across, down))


def _shares(name: str, given: object, count: int) -> list[float]:
    """So many places as shares of the picture, in [0, 1]."""
    numbers = given if isinstance(given, list) and len(given) == count else []
    if not numbers or not all(isinstance(n, int | float) and 0 <= n <= GRAIN for n in numbers):
        raise CompletionFailed(
            f"the vision model gave {name!r} the place {str(given)[:80]}; {count} numbers from 0 "
            f"to {GRAIN} are wanted"
        )
    return [number / GRAIN for number in numbers]
