"""Trained matrices → a GGUF adapter that llama.cpp loads, and the card that goes with it."""

import hashlib
import json
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field
from pathlib import Path

import gguf  # pyright: ignore[reportMissingImports]
import numpy as np

TENSORS = {
    "q_proj": "attn_q",
    "k_proj": "attn_k",
    "v_proj": "attn_v",
    "o_proj": "attn_output",
    "gate_proj": "ffn_gate",
    "up_proj": "ffn_up",
    "down_proj": "ffn_down",
}


@dataclass(frozen=True, slots=True, kw_only=True)
class Card:
    """What an adapter is, where it comes from and what it was measured to do."""

    name: str
    base: str
    """Name of the base model's file."""
    base_sha256: str
    adapter_sha256: str
    drafts_sha256: str
    prompt: str = "app.programs.sketches.prompt"
    licence: str = "Apache-2.0, as the base model"
    training: dict[str, object] = field(default_factory=dict)
    figures: dict[str, object] = field(default_factory=dict)
    """Suite → strict Plan SR, with 95 % Wilson intervals and per kind."""
    limits: tuple[str, ...] = ()

    def write(self, path: Path) -> None:
        """As JSON, stable in its order."""
        path.write_text(json.dumps(asdict(self), indent=2, ensure_ascii=False) + "\n", "utf-8")


def write_adapter(
    arrays: Mapping[str, np.ndarray], alpha: float, base: Path, out: Path, name: str
) -> None:
    """Write ``<layer>.<projection>.a`` (r, in) and ``.b`` (out, r) as a LoRA in half precision."""
    architecture = gguf.GGUFReader(base).fields["general.architecture"].contents()
    writer = gguf.GGUFWriter(out, architecture)
    writer.add_type(gguf.GGUFType.ADAPTER)
    writer.add_string(gguf.Keys.Adapter.TYPE, "lora")
    writer.add_float32(gguf.Keys.Adapter.LORA_ALPHA, alpha)
    writer.add_name(name)
    writer.add_file_type(gguf.LlamaFileType.MOSTLY_F16)
    for key in sorted(arrays, key=_place):
        layer, projection, part = key.split(".")
        writer.add_tensor(
            f"blk.{layer}.{TENSORS[projection]}.weight.lora_{part}",
            np.ascontiguousarray(arrays[key].astype(np.float16)),
        )
    writer.write_header_to_file()
    writer.write_kv_data_to_file()
    writer.write_tensors_to_file()
    writer.close()


def read_adapter(path: Path) -> dict[str, np.ndarray]:
    """What ``write_adapter`` wrote: ``<layer>.<projection>.a`` (r, in) and ``.b`` (out, r) [fp32]."""
    projections = {name: projection for projection, name in TENSORS.items()}
    found: dict[str, np.ndarray] = {}
    for tensor in gguf.GGUFReader(path).tensors:
        _, layer, name, _, part = tensor.name.split(".")
        found[f"{layer}.{projections[name]}.{part.removeprefix('lora_')}"] = np.array(
            tensor.data, np.float32
        )
    return found


def sha256(path: Path) -> str:
    """The file's checksum, in hexadecimal."""
    digest = hashlib.sha256()
    with path.open("rb") as stream:
        while block := stream.read(1 << 20):
            digest.update(block)
    return digest.hexdigest()


def _place(key: str) -> tuple[int, str]:
    layer, _, rest = key.partition(".")
    return int(layer), rest
