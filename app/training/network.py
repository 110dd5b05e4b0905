"""The base model in torch, made from its GGUF file, with low-rank adapters on its upper layers."""

import math
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import torch  # pyright: ignore[reportMissingImports]
from torch import nn  # pyright: ignore[reportMissingImports]
from torch.nn import functional  # pyright: ignore[reportMissingImports]
from transformers import AutoModelForCausalLM, AutoTokenizer  # pyright: ignore[reportMissingImports]

PROJECTIONS = ("q_proj", "k_proj", "v_proj", "o_proj", "gate_proj", "up_proj", "down_proj")


@dataclass(frozen=True, slots=True, kw_only=True)
class LoraShape:
    """How large the adapter is."""

    rank: int = 16
    alpha: float = 32.0
    first_layer: int = 0
    """Layers below stay as they are; nothing is propagated back through them."""


class LoraLinear(nn.Module):
    """``y = W x + (alpha / r) B A x`` with W frozen, A (r, in) and B (out, r)."""

    def __init__(self, frozen: nn.Linear, shape: LoraShape) -> None:
        super().__init__()
        self.frozen = frozen
        self.scale = shape.alpha / shape.rank
        self.a = nn.Parameter(
            torch.randn(shape.rank, frozen.in_features) / math.sqrt(frozen.in_features)
        )
        self.b = nn.Parameter(torch.zeros(frozen.out_features, shape.rank))

    def forward(self, x: torch.Tensor) -> torch.Tensor:
        return self.frozen(x) + functional.linear(functional.linear(x, self.a), self.b * self.scale)


class Network:
    """A causal language model whose adapters can be trained."""

    def __init__(self, base: Path, shape: LoraShape, threads: int) -> None:
        torch.set_num_threads(threads)
        torch.manual_seed(0)
        folder = _unpacked(base)
        self.tokenizer: Any = AutoTokenizer.from_pretrained(folder)
        self.model: Any = AutoModelForCausalLM.from_pretrained(folder, dtype=torch.float32)
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

    def loss(
        self, prefix: list[int], branches: list[tuple[list[int], list[int]]]
    ) -> tuple[torch.Tensor, int]:
        """Summed cross-entropy of the answers, and how many tokens they are.

        Each branch (question, answer) goes on from the same prefix and sees nothing of the others:
        one sequence with a block mask, positions counted from the prefix's end.
        """
        ids, positions, mask, wanted = _packed(prefix, branches)
        hidden = self.model.model(
            input_ids=ids, position_ids=positions, attention_mask=mask, use_cache=False
        ).last_hidden_state[0]
        before = torch.tensor([index for index, _ in wanted])
        targets = torch.tensor([token for _, token in wanted])
        logits = self.model.lm_head(hidden[before])
        return functional.cross_entropy(logits, targets, reduction="sum"), len(wanted)

    def arrays(self) -> dict[str, np.ndarray]:
        """The adapters' weights: ``<layer>.<projection>.a`` (r, in) and ``.b`` (out, r)."""
        return {
            f"{name}.{part}": getattr(adapter, part).detach().numpy()
            for name, adapter in self.adapters.items()
            for part in ("a", "b")
        }


def _packed(
    prefix: list[int], branches: list[tuple[list[int], list[int]]]
) -> tuple[torch.Tensor, torch.Tensor, torch.Tensor, list[tuple[int, int]]]:
    ids, positions = list(prefix), list(range(len(prefix)))
    spans: list[tuple[int, int]] = []
    wanted: list[tuple[int, int]] = []
    for question, answer in branches:
        start = len(ids)
        ids += question + answer
        positions += range(len(prefix), len(prefix) + len(question) + len(answer))
        spans.append((start, len(ids)))
        first = start + len(question)
        wanted += [(first + offset - 1, token) for offset, token in enumerate(answer)]
    allowed = torch.ones(len(ids), len(ids)).tril().bool()
    for start, end in spans:
        allowed[start:end, len(prefix) : start] = False
    mask = torch.zeros(1, 1, len(ids), len(ids)).masked_fill(
        ~allowed, torch.finfo(torch.float32).min
    )
    return torch.tensor([ids]), torch.tensor([positions]), mask, wanted


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
