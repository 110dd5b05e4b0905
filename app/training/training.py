"""Examples → adapter: a loop that can be stopped at any moment and taken up again."""

import itertools
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from random import Random

import numpy as np
import torch  # pyright: ignore[reportMissingImports]

from app.training.example import Example
from app.training.generator import generate
from app.training.network import Network, Pair

WARM_UP = 20
"""Steps until the learning rate is at its full height."""
FLOOR = 0.05
"""Of the full learning rate, what is left at the end."""
POOL = 12
"""Batches that are made at once, so that each has examples of about one length."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Schedule:
    """How long, how fast."""

    examples: int = 12_000
    """To learn from; each is seen once."""
    minutes: float = 60.0
    """Wall time after which it ends even so [min]."""
    batch: int = 8
    """Examples to a step."""
    rate: float = 6e-4
    """Of learning, at its height."""
    seed: int = 1
    save_every: float = 90.0
    """Between checkpoints [s]."""
    data: Path | None = None
    """A folder of a user's own words."""


@dataclass(slots=True)
class Progress:
    """Where a run stands."""

    examples: int = 0
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
    saved = started = time.monotonic()
    earlier = progress.seconds
    for batch in batches(network, schedule, progress.examples):
        if (done := _share_done(progress, schedule)) >= 1:
            break
        for group in optimizer.param_groups:
            group["lr"] = (
                schedule.rate * min(1, (progress.steps + 1) / WARM_UP) * max(FLOOR, 1 - done)
            )
        _step(network, optimizer, batch, progress)
        now = time.monotonic()
        progress.seconds = earlier + now - started
        if progress.steps % 5 == 0:
            say(
                f"{progress.examples} examples, loss {progress.loss:.3f}, {progress.tokens / progress.seconds:.1f} tokens/s, {progress.seconds:.0f} s"
            )
        if now - saved > schedule.save_every:
            _save(network, optimizer, checkpoint, progress)
            saved = now
    _save(network, optimizer, checkpoint, progress)
    return progress


def batches(network: Network, schedule: Schedule, first: int) -> Iterator[list[Pair]]:
    """Tokenized examples without end, those of a batch of about one length."""
    first -= first % (schedule.batch * POOL)
    examples = generate(schedule.seed, "train", schedule.data, first)
    for number in itertools.count(first):
        pool = [
            tokenize(network, example)
            for example in itertools.islice(examples, schedule.batch * POOL)
        ]
        pool.sort(key=lambda pair: len(pair[0]) + len(pair[1]))
        parts = [pool[i : i + schedule.batch] for i in range(0, len(pool), schedule.batch)]
        Random(number).shuffle(parts)
        yield from parts


def _share_done(progress: Progress, schedule: Schedule) -> float:
    return max(progress.examples / schedule.examples, progress.seconds / (60 * schedule.minutes))


def _step(
    network: Network, optimizer: torch.optim.Optimizer, batch: list[Pair], progress: Progress
) -> None:
    optimizer.zero_grad()
    loss, answers = network.loss(batch)
    (loss / answers).backward()
    torch.nn.utils.clip_grad_norm_(network.parameters(), 1.0)
    optimizer.step()
    mean = loss.item() / answers
    progress.tokens += sum(len(prompt) + len(answer) for prompt, answer in batch)
    progress.examples += len(batch)
    progress.steps += 1
    progress.loss = mean if progress.steps == 1 else 0.95 * progress.loss + 0.05 * mean


def tokenize(network: Network, example: Example) -> Pair:
    """Prompt and answer apart, as they are when the model goes on from the prompt."""
    return network.tokens(example.prompt), [*network.tokens(example.target), network.end]


def _save(network: Network, optimizer: torch.optim.AdamW, path: Path, progress: Progress) -> None:
    moments = {
        f"{key}/{index}": state[key].cpu().numpy() if hasattr(state[key], "cpu") else state[key]
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
        network.load(stored)
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
