"""What the settings say about language models."""

from app.llm.embeddings import take_from
from app.llm.models import Endpoint, LlmConfig
from app.llm.vision import VisionEndpoint
from app.settings import Settings
from app.worker.models import Models


def vision_endpoint(settings: Settings) -> VisionEndpoint | None:
    """The vision model, if there is one."""
    if not settings.vision_url:
        return None
    return VisionEndpoint(
        Endpoint(
            base_url=settings.vision_url,
            model=settings.vision_model or "default",
            key=settings.vision_key,
        )
    )


def llm_config(settings: Settings) -> LlmConfig:
    """The configuration of the models."""
    endpoints: list[tuple[str, Endpoint]] = []
    if settings.endpoint_url:
        endpoint = Endpoint(
            base_url=settings.endpoint_url,
            model=settings.endpoint_model or "default",
            key=settings.endpoint_key,
            chat=settings.endpoint_chat,
            grammar=settings.endpoint_grammar,
        )
        endpoints.append(("endpoint", endpoint))
    if settings.anthropic_model:
        endpoint = Endpoint(
            protocol="anthropic",
            base_url=settings.anthropic_url,
            model=settings.anthropic_model,
            key=settings.anthropic_key,
        )
        endpoints.append(("anthropic", endpoint))
    return LlmConfig(
        cache_dir=settings.cache,
        model_path=settings.model_path,
        threads=settings.threads,
        most_models=settings.most_models,
        endpoints=tuple(endpoints),
        scripted_file=settings.scripted,
    )


def open_models(config: LlmConfig, default: str) -> Models:
    """What opens language models in this process; its sentence embeddings come from where they do."""
    take_from(config)
    return Models(config, default)
