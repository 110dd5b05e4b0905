"""The base model in torch, made from its GGUF file, with low-rank adapters on its upper layers."""

import math
import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import torch  # pyright: ignore[reportMissingImports]
from torch import nn  # pyright: ignore[reportMissingImports]
from torch.nn import functional  # pyright: ignore[reportMissingImports]
from transformers import AutoModelForCausalLM, AutoTokenizer  # pyright: ignore[reportMissingImports]

FREQUENT = 24_000
"""The output layer is trained over the most frequent tokens and the batch's own: a fifth of the cost."""
PROJECTIONS = ("q_proj", "k_proj", "v_proj", "o_proj", "gate_proj", "up_proj", "down_proj")
Pair = tuple[list[int], list[int]]
"""A prompt's tokens and its answer's."""


@dataclass(frozen=True, slots=True, kw_only=True)
class LoraShape:
    """How large the adapter is."""

    rank: int = 16
    alpha: float = 32.0
    first_layer: int = 0
    """Layers below stay as they are; nothing is propagated back through them."""


class LoraLinear(nn.Module):
    """``y = W x + (alpha / r) B A x`` with W frozen, A (r, in) and B (out, r).

    W is in the precision that this machine multiplies fastest in; A and B are kept in fp32, since
    the optimizer's steps are smaller than bfloat16 can tell apart.
    """

    def __init__(self, frozen: nn.Linear, shape: LoraShape) -> None:
        super().__init__()
        self.frozen = frozen
        self.scale = shape.alpha / shape.rank
        self.a = nn.Parameter(
            torch.randn(shape.rank, frozen.in_features) / math.sqrt(frozen.in_features)
        )
        self.b = nn.Parameter(torch.zeros(frozen.out_features, shape.rank))

    def forward(self, x: torch.Tensor) -> torch.Tensor:
        low = functional.linear(x, self.a.to(x.dtype))
        return self.frozen(x) + functional.linear(low, (self.b * self.scale).to(x.dtype))


class Network:
    """A causal language model whose adapters can be trained."""

    def __init__(self, base: Path, shape: LoraShape, threads: int, device: str = "cpu") -> None:
        torch.set_num_threads(threads)
        torch.manual_seed(0)
        folder = _unpacked(base)
        self.device = device
        self.tokenizer: Any = AutoTokenizer.from_pretrained(folder)
        self.model: Any = AutoModelForCausalLM.from_pretrained(folder, dtype=_fastest(device))
        self.model.requires_grad_(False)
        self.model.eval()
        self.shape = shape
        self.adapters: dict[str, LoraLinear] = {}
        for index, layer in enumerate(
            self.model.model.layers[shape.first_layer :], shape.first_layer
        ):
            for part in (layer.self_attn, layer.mlp):
                for name in PROJECTIONS:
                    if hasattr(part, name):
                        adapter = LoraLinear(getattr(part, name), shape)
                        setattr(part, name, adapter)
                        self.adapters[f"{index}.{name}"] = adapter
        self.model.to(device)

    def parameters(self) -> list[nn.Parameter]:
        """What is trained, in a fixed order."""
        return [each for adapter in self.adapters.values() for each in (adapter.a, adapter.b)]

    def tokens(self, text: str) -> list[int]:
        """The text's token ids, nothing added."""
        return self.tokenizer(text, add_special_tokens=False).input_ids

    @property
    def end(self) -> int:
        """The token that ends an answer."""
        return self.tokenizer.convert_tokens_to_ids("<|im_end|>")

    def loss(self, pairs: Sequence[Pair]) -> tuple[torch.Tensor, int]:
        """Summed cross-entropy of the answers, and how many tokens they are.

        The pairs are padded at their ends to one length: attention looks back only, so that no
        mask is needed. Only the answers' tokens go through the output layer.
        """
        longest = max(len(prompt) + len(answer) for prompt, answer in pairs)
        ids = torch.full((len(pairs), longest), self.end)
        wanted: list[tuple[int, int, int]] = []
        for row, (prompt, answer) in enumerate(pairs):
            whole = prompt + answer
            ids[row, : len(whole)] = torch.tensor(whole)
            wanted += [(row, len(prompt) + i - 1, token) for i, token in enumerate(answer)]
        rows, columns, targets = (
            part.contiguous() for part in torch.tensor(wanted, device=self.device).T
        )
        hidden = self.model.model(input_ids=ids.to(self.device), use_cache=False).last_hidden_state
        logits, targets = self._contest(hidden[rows, columns], ids.to(self.device), targets)
        return functional.cross_entropy(logits.float(), targets, reduction="sum"), len(wanted)

    def _contest(
        self, hidden: torch.Tensor, ids: torch.Tensor, targets: torch.Tensor
    ) -> tuple[torch.Tensor, torch.Tensor]:
        """Scores of the frequent tokens and the batch's rarer ones, and the targets among them."""
        weight = self.model.lm_head.weight
        rare = torch.unique(ids)
        rare = rare[rare >= FREQUENT]
        logits = torch.cat((hidden @ weight[:FREQUENT].T, hidden @ weight[rare].T), dim=1)
        places = torch.where(
            targets < FREQUENT, targets, FREQUENT + torch.searchsorted(rare, targets)
        )
        return logits, places

    def arrays(self) -> dict[str, np.ndarray]:
        """The adapters' weights: ``<layer>.<projection>.a`` (r, in) and ``.b`` (out, r)."""
        return {
            f"{name}.{part}": getattr(adapter, part).detach().cpu().numpy()
            for name, adapter in self.adapters.items()
            for part in ("a", "b")
        }

    def load(self, arrays: Mapping[str, np.ndarray]) -> None:
        """Take the adapters' weights from what ``arrays`` gives."""
        for name, adapter in self.adapters.items():
            adapter.a.data.copy_(torch.from_numpy(arrays[f"{name}.a"]))
            adapter.b.data.copy_(torch.from_numpy(arrays[f"{name}.b"]))


def _fastest(device: str) -> torch.dtype:
    """bfloat16 or fp32, whichever matrices are multiplied faster in.

    With AMX or AVX-512 it is bfloat16 by four times, without them fp32 by six.
    """
    return min((torch.bfloat16, torch.float32), key=lambda dtype: _seconds(dtype, device))


def _seconds(dtype: torch.dtype, device: str) -> float:
    """That the fastest of a few multiplications takes."""
    a, b = (torch.ones(256, 1024, dtype=dtype, device=device) for _ in range(2))

    def multiply() -> float:
        started = time.perf_counter()
        float((a @ b.T)[0, 0])  # A read waits for the device.
        return time.perf_counter() - started

    return min(multiply() for _ in range(5))


def _unpacked(base: Path) -> Path:
    """The GGUF file's weights as a transformers folder beside it, made once [fp32]."""
    folder = base.with_suffix(".torch")
    if not (folder / "config.json").exists():
        source = {"pretrained_model_name_or_path": str(base.parent), "gguf_file": base.name}
        tokenizer = AutoTokenizer.from_pretrained(**source)
        model = AutoModelForCausalLM.from_pretrained(**source, dtype=torch.float32)
        if hasattr(model.config, "quantization_config"):
            del model.config.quantization_config
        plain = type(model)(model.config).float()
        plain.load_state_dict(model.state_dict())
        tokenizer.save_pretrained(folder)
        plain.save_pretrained(folder)
    return folder
