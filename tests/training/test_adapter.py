from pathlib import Path

import numpy as np
import pytest

gguf = pytest.importorskip("gguf")


def base_file(path: Path) -> Path:
    writer = gguf.GGUFWriter(path, "qwen2")
    writer.add_tensor("output_norm.weight", np.ones(4, np.float32))
    writer.write_header_to_file()
    writer.write_kv_data_to_file()
    writer.write_tensors_to_file()
    writer.close()
    return path


def test_an_adapter_file_names_its_base_and_holds_half_precision_pairs(tmp_path: Path) -> None:
    from app.training.adapter import write_adapter  # noqa: PLC0415

    arrays = {"3.q_proj.a": np.ones((2, 6), np.float32), "3.q_proj.b": np.ones((5, 2), np.float32)}
    out = tmp_path / "adapter.gguf"
    write_adapter(arrays, 32.0, base_file(tmp_path / "base.gguf"), out, "mine")
    reader = gguf.GGUFReader(out)
    fields = {name: reader.fields[name].contents() for name in ("general.type", "adapter.type")}
    assert fields == {"general.type": "adapter", "adapter.type": "lora"}
    assert reader.fields["general.architecture"].contents() == "qwen2"
    shapes = {tensor.name: tuple(tensor.shape) for tensor in reader.tensors}
    assert shapes == {"blk.3.attn_q.weight.lora_a": (6, 2), "blk.3.attn_q.weight.lora_b": (2, 5)}


def test_an_adapter_is_read_back_as_it_was_written(tmp_path: Path) -> None:
    from app.training.adapter import read_adapter, write_adapter  # noqa: PLC0415

    rng = np.random.default_rng(0)
    arrays = {
        "3.q_proj.a": rng.normal(size=(2, 6)).astype(np.float16).astype(np.float32),
        "3.q_proj.b": rng.normal(size=(5, 2)).astype(np.float16).astype(np.float32),
    }
    out = tmp_path / "adapter.gguf"
    write_adapter(arrays, 32.0, base_file(tmp_path / "base.gguf"), out, "mine")
    found = read_adapter(out)
    assert found.keys() == arrays.keys()
    assert all((found[name] == arrays[name]).all() for name in arrays)
