"""The worlds a plan can be carried out in, one per file."""

from app.domain.world import WorldDescription
from app.registry import Registry

worlds: Registry[WorldDescription] = Registry(__name__, "world")
