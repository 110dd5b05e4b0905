"""The planners by name."""

from app.domain.planner import Planner
from app.registry import Registry

planners: Registry[Planner] = Registry(__name__, "planner")
