"""Viser's wire form: what one message of a viewer's WebSocket looks like."""

import time
from collections.abc import Sequence
from typing import Any

import msgspec
import zstandard

WORD = 8
"""All parts begin at a multiple of this [bytes]; lengths are little-endian words."""


def packed(messages: Sequence[dict[str, Any]], arrays: Sequence[bytes] = ()) -> bytes:
    """``messages`` as viser's client takes them; they name ``arrays`` by their place."""
    inner = msgspec.msgpack.encode(
        {
            "messages": messages,
            "timestampSec": time.perf_counter(),
            "binaryBufferLengths": [len(array) for array in arrays],
        }
    )
    compressed = zstandard.ZstdCompressor(level=1).compress(inner)
    packet = bytearray(_word(len(inner)) + _word(len(compressed)) + compressed)
    for array in arrays:
        packet += bytes(-len(packet) % WORD) + array
    return bytes(packet)


def unpacked(recording: bytes) -> tuple[list[dict[str, Any]], list[bytes]]:
    """The messages of a ``.viser`` file, whenever they come, and its arrays."""
    inner = zstandard.ZstdDecompressor().decompressobj().decompress(recording[WORD:])
    start = WORD + int.from_bytes(inner[:WORD], "little")
    content = msgspec.msgpack.decode(inner[WORD:start])
    arrays: list[bytes] = []
    for length in content["binaryBufferLengths"]:
        start += -start % WORD
        arrays.append(inner[start : start + length])
        start += length
    return [message for _, message in content["messages"]], arrays


def _word(number: int) -> bytes:
    return number.to_bytes(WORD, "little")
