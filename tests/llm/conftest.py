import hashlib
import os
import random
import threading
import zipfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

import pytest

from app.llm.backend import LlmConfig
from app.llm.backends.local import LocalModel
from app.llm.models import find_model, open_model
from app.llm.sources import weight_store
from app.llm.weights import WeightFile, WeightPackages

BYTES = random.Random(0).randbytes(250_000)
PART_BYTES = 60_000


@pytest.fixture(autouse=True)
def no_settings(monkeypatch):
    for variable in [name for name in os.environ if name.startswith("PROGPROMPT_")]:
        if variable != "PROGPROMPT_CACHE":
            monkeypatch.delenv(variable)


@pytest.fixture
def weights() -> WeightFile:
    """A file of weights like the real ones, but small."""
    return WeightFile(
        name="tiny.gguf",
        bytes=len(BYTES),
        sha256=hashlib.sha256(BYTES).hexdigest(),
        hub_path="somebody/tiny/resolve/main/tiny.gguf",
        packages=WeightPackages(
            name="tiny-part{part}",
            member="tiny_part{part}/data/part{part:02}.bin",
            version="1.0",
            count=5,
            part_bytes=PART_BYTES,
        ),
    )


@pytest.fixture
def content() -> bytes:
    return BYTES


class Wheels:
    """Makes wheels as an index would give them, and remembers which were asked for."""

    def __init__(self, content: bytes) -> None:
        self.content = content
        self.asked: list[str] = []

    def __call__(self, requirement: str, folder: Path) -> None:
        self.asked.append(requirement)
        number = int(requirement.removeprefix("tiny-part").removesuffix("==1.0"))
        piece = self.content[(number - 1) * PART_BYTES : number * PART_BYTES]
        with zipfile.ZipFile(folder / f"tiny_part{number}-1.0-py3-none-any.whl", "w") as wheel:
            wheel.writestr(f"tiny_part{number}/data/part{number:02}.bin", piece)


@pytest.fixture
def wheels() -> Wheels:
    return Wheels(BYTES)


@contextmanager
def serving(handler: type[BaseHTTPRequestHandler]) -> Iterator[str]:
    server = ThreadingHTTPServer(("127.0.0.1", 0), handler)
    thread = threading.Thread(target=server.serve_forever, args=(0.02,))
    thread.start()
    try:
        yield f"http://127.0.0.1:{server.server_port}"
    finally:
        server.shutdown()
        thread.join()
        server.server_close()


@pytest.fixture
def serve() -> Iterator[Callable[[type[BaseHTTPRequestHandler]], str]]:
    """Starts HTTP servers that end with the test; returns their base URL."""
    with_exit: list = []

    def start(handler: type[BaseHTTPRequestHandler]) -> str:
        context = serving(handler)
        with_exit.append(context)
        return context.__enter__()

    yield start
    for context in reversed(with_exit):
        context.__exit__(None, None, None)


@pytest.fixture(scope="session")
def small_config(tmp_path_factory: pytest.TempPathFactory) -> LlmConfig:
    """Settings under which the small model is there, with a cache of its own for states.

    Its weights come from the user's cache; they are fetched into it where they are absent.
    """
    user = LlmConfig()
    weights = find_model("small", user).weights
    assert weights
    path = weight_store(user).ensure(weights)
    return LlmConfig(cache_dir=tmp_path_factory.mktemp("cache"), model_path=path)


@pytest.fixture(scope="session")
def small_model(small_config: LlmConfig) -> Iterator[LocalModel]:
    model = open_model("small", small_config)
    assert isinstance(model, LocalModel)
    yield model
    model.close()
