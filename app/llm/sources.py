"""The sources of weights in the order in which they are tried, as the settings say."""

from app.llm.backend import LlmConfig
from app.llm.hub import ModelHub
from app.llm.weight_packages import PackageIndex
from app.llm.weights import Notice, WeightStore, log


def weight_store(config: LlmConfig, notice: Notice = log.warning) -> WeightStore:
    """The store of these settings: the path they name, the cache, the hub, the package index."""
    return WeightStore(
        config.cache,
        (ModelHub(config.hub_url), PackageIndex()),
        given=config.model_path,
        notice=notice,
    )
