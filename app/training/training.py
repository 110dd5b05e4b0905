"""Examples → adapter: a loop that can be stopped at any moment and taken up again."""

import itertools
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import torch  # pyright: ignore[reportMissingImports]

from app.training.generator import Example, generate
from app.training.network import Network

WARM_UP = 8
"""Steps until the learning rate is at its full height."""
FLOOR = 0.05
"""Of the full learning rate, what is left at the end."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Schedule:
    """How long, how fast."""

    scenes: int = 800
    """Examples to learn from, of up to four tasks each."""
    minutes: float = 60.0
    """Wall time after which it ends even so [min]."""
    batch: int = 1
    """Scenes to a step."""
    rate: float = 5e-4
    seed: int = 1
    save_every: float = 120.0
    """Between checkpoints [s]."""


@dataclass(slots=True)
class Progress:
    """Where a run stands."""

    scenes: int = 0
    steps: int = 0
    tokens: int = 0
    seconds: float = 0.0
    loss: float = float("nan")
    """Running mean per answer token [nat]."""


Say = Callable[[str], None]


def train(network: Network, schedule: Schedule, checkpoint: Path, say: Say) -> Progress:
    """Learn until the schedule ends; takes up ``checkpoint`` (``.npz``) where there is one."""
    optimizer = torch.optim.AdamW(
        network.parameters(), lr=schedule.rate, weight_decay=0.0, betas=(0.9, 0.98)
    )
    progress = _restore(network, optimizer, checkpoint)
    examples = itertools.islice(generate(schedule.seed, "train"), progress.scenes, None)
    saved = started = time.monotonic()
    earlier = progress.seconds
    while (done := _share_done(progress, schedule)) < 1:
        for group in optimizer.param_groups:
            group["lr"] = (
                schedule.rate * min(1, (progress.steps + 1) / WARM_UP) * max(FLOOR, 1 - done)
            )
        _step(network, optimizer, list(itertools.islice(examples, schedule.batch)), progress)
        now = time.monotonic()
        progress.seconds = earlier + now - started
        if progress.steps % 5 == 0:
            say(
                f"{progress.scenes} scenes, loss {progress.loss:.3f}, {progress.tokens / progress.seconds:.1f} tokens/s, {progress.seconds:.0f} s"
            )
        if now - saved > schedule.save_every:
            _save(network, optimizer, checkpoint, progress)
            saved = now
    _save(network, optimizer, checkpoint, progress)
    return progress


def _share_done(progress: Progress, schedule: Schedule) -> float:
    return max(progress.scenes / schedule.scenes, progress.seconds / (60 * schedule.minutes))


def _step(
    network: Network, optimizer: torch.optim.Optimizer, batch: list[Example], progress: Progress
) -> None:
    optimizer.zero_grad()
    tokenized = [tokenize(network, example) for example in batch]
    answers = sum(len(answer) for _, branches in tokenized for _, answer in branches)
    total = 0.0
    for prefix, branches in tokenized:
        loss, _ = network.loss(prefix, branches)
        (loss / answers).backward()
        total += loss.item() / answers
        progress.tokens += len(prefix) + sum(len(q) + len(a) for q, a in branches)
    torch.nn.utils.clip_grad_norm_(network.parameters(), 1.0)
    optimizer.step()
    progress.scenes += len(batch)
    progress.steps += 1
    progress.loss = total if progress.steps == 1 else 0.9 * progress.loss + 0.1 * total


def tokenize(
    network: Network, example: Example
) -> tuple[list[int], list[tuple[list[int], list[int]]]]:
    """The example's prefix and its branches; prompts are cut where the completion begins."""
    prefix = network.tokens(example.situation)
    branches = [
        (network.tokens(part.question), [*network.tokens(part.target), network.end])
        for part in example.parts
    ]
    return prefix, branches


def _save(network: Network, optimizer: torch.optim.AdamW, path: Path, progress: Progress) -> None:
    moments = {
        f"{key}/{index}": state[key].numpy() if hasattr(state[key], "numpy") else state[key]
        for index, state in optimizer.state_dict()["state"].items()
        for key in ("step", "exp_avg", "exp_avg_sq")
    }
    counts = {f"progress/{name}": getattr(progress, name) for name in Progress.__slots__}
    partial = path.with_suffix(".partial.npz")
    np.savez(partial, **network.arrays(), **moments, **counts)
    partial.replace(path)


def _restore(network: Network, optimizer: torch.optim.AdamW, path: Path) -> Progress:
    progress = Progress()
    if not path.exists():
        return progress
    with np.load(path) as stored:
        for name, adapter in network.adapters.items():
            adapter.a.data.copy_(torch.from_numpy(stored[f"{name}.a"]))
            adapter.b.data.copy_(torch.from_numpy(stored[f"{name}.b"]))
        state = optimizer.state_dict()
        state["state"] = dict(_moments(stored, len(network.parameters())))
        optimizer.load_state_dict(state)
        for name in Progress.__slots__:
            kind = type(getattr(progress, name))
            setattr(progress, name, kind(stored[f"progress/{name}"]))
    return progress


def _moments(
    stored: np.lib.npyio.NpzFile, count: int
) -> Iterator[tuple[int, dict[str, torch.Tensor]]]:
    for index in range(count):
        keys = ("step", "exp_avg", "exp_avg_sq")
        yield index, {key: torch.as_tensor(stored[f"{key}/{index}"]) for key in keys}
