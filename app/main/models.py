"""What the settings say about language models."""

from app.llm.models import Endpoint, LlmConfig
from app.settings import Settings


def llm_config(settings: Settings) -> LlmConfig:
    """The configuration of the models."""
    endpoints: tuple[tuple[str, Endpoint], ...] = ()
    if settings.endpoint_url:
        endpoint = Endpoint(
            base_url=settings.endpoint_url,
            model=settings.endpoint_model or "default",
            key=settings.endpoint_key,
        )
        endpoints = (("endpoint", endpoint),)
    return LlmConfig(
        cache_dir=settings.cache,
        model_path=settings.model_path,
        threads=settings.threads,
        endpoints=endpoints,
        scripted_file=settings.scripted,
    )
