"""The model hub as a source of weights: one file over HTTPS, taken up where it broke off."""

from contextlib import closing
from pathlib import Path

import httpx

from app.domain.errors import CompletionFailed, ModelError, ModelUnavailable
from app.llm.transport import Patience, Transport
from app.llm.weights import Progress, WeightFile

PATIENCE = Patience(connect=5.0, read=30.0, attempts=1)
"""One attempt: where the hub cannot be reached, the next source is not kept waiting."""


class ModelHub:
    """Files by their path under one base URL."""

    def __init__(self, base_url: str, transport: httpx.BaseTransport | None = None) -> None:
        self.name = base_url
        self._transport = transport

    def spare(self, weights: WeightFile) -> int:
        """Nothing lies beside the file itself [bytes]."""
        del weights  # Unused.
        return 0

    def fetch(self, weights: WeightFile, part: Path, progress: Progress) -> None:
        """Append what ``part`` lacks; asked again for the rest as long as some of it comes."""
        gate = Transport(self.name, patience=PATIENCE, transport=self._transport)
        with closing(gate):
            while (before := part.stat().st_size) < weights.bytes:
                try:
                    self._append(gate, weights, part, progress)
                except ModelError as error:
                    if part.stat().st_size <= before:
                        raise ModelUnavailable(str(error)) from error

    def _append(self, gate: Transport, weights: WeightFile, part: Path, progress: Progress) -> None:
        done = part.stat().st_size
        # A compressed body could not be taken up in the middle.
        headers = {"Range": f"bytes={done}-", "Accept-Encoding": "identity"}
        with gate.stream("GET", weights.hub_path, headers=headers, redirects=True) as response:
            whole = response.status_code == httpx.codes.OK  # Range was not heeded: from the start
            done = 0 if whole else done
            rest = int(response.headers.get("Content-Length", weights.bytes - done))
            if done + rest != weights.bytes:
                raise CompletionFailed(
                    f"the file there has {done + rest:,} bytes instead of {weights.bytes:,}"
                )
            with part.open("wb" if whole else "ab") as file:
                for block in response.iter_raw():  # as it comes: nothing is lost at a break
                    file.write(block)
                    done += len(block)
                    progress(done, weights.bytes, self.name)
