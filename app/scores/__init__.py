"""The scores by name."""

from app.domain.score import Scorer
from app.registry import Registry

scores: Registry[Scorer] = Registry(__name__, "score")
