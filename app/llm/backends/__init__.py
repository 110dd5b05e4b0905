"""Ways of reaching language models, one per module of this folder."""

from app.llm.backend import Backend
from app.registry import Registry

backends: Registry[Backend] = Registry(__name__, "backend")
