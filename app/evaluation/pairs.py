"""Pair benchmark: every object kind let down into every container, to see that physics holds."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass

import mujoco
import numpy as np

from app.domain.scene import Scene, SceneObject
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.simulators.mujoco.physics import Physics
from app.worlds.simulators.mujoco.scene_builder import ObjectBody, build

DROP = 0.004
"""An object is let go so far above where it would first touch a container [m]."""
LOWERED = 0.002
"""Steps in which that place is looked for [m]."""
SECONDS = (2.0, 0.5)
"""How long it may come to rest, and how long it is then looked at [s]."""
DEEPEST = 0.002
"""So deep things may sink into one another at rest [m]."""
FASTEST = 0.6
"""So fast nothing may become that is let go from so low [m/s]."""
DRIFT = 0.001
"""So far what rests may move while it is looked at [m]."""
SNUG = 0.7
"""What is no wider than this share of the opening has room on the floor, walls being slanted."""
PLACE = (0.5, 0.0)
"""Where the container stands [m]."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Pair:
    """One object let down into one container."""

    item: str
    container: str
    deepest: float
    """Of all contacts at the end [m]."""
    fastest: float
    """Of the object, on its way [m/s]."""
    drift: float
    """Of the object, while it is looked at [m]."""
    rolling: bool
    """Round things may roll on."""

    @property
    def fault(self) -> str | None:
        """What is wrong with it, or None."""
        if self.fastest > FASTEST:
            return "flies"
        if self.deepest > DEEPEST:
            return "sinks in"
        return "does not rest" if self.drift > DRIFT and not self.rolling else None


def every_pair() -> Iterator[tuple[str, str]]:
    """Each kind with each container, those with a drawer, a door or a lid left out."""
    plain = [name for name in kinds if kinds[name].articulation(kinds[name].largest) is None]
    for container in plain:
        if kinds[container].container:
            yield from ((item, container) for item in plain if item != container)


def bench_pairs(
    pairs: Iterator[tuple[str, str]], on_pair: Callable[[Pair], None] = lambda _: None
) -> tuple[Pair, ...]:
    """Try each of them."""
    tried: list[Pair] = []
    for item, container in pairs:
        tried.append(try_pair(item, container))
        on_pair(tried[-1])
    return tuple(tried)


def try_pair(item: str, container: str) -> Pair:
    """Let the item down into the container, both of the middle of their sizes."""
    scene = Scene(
        world="tabletop",
        objects=(_object(container, PLACE), _object(item, (PLACE[0], PLACE[1] + 0.4))),
    )
    physics = Physics(build(scene, visuals=False))
    body, other = physics.bodies[item], physics.bodies[container]
    assert other.opening is not None
    fits = body.footprint_radius < SNUG * other.opening.radius
    start = body.qpos_address
    physics.data.qpos[start : start + 3] = (*PLACE, _lowest_clear(physics, body, other) + DROP)
    speed = slice(body.dof_address, body.dof_address + 3)
    fastest = 0.0
    for _ in range(physics.steps_in(SECONDS[0])):
        physics.step()
        fastest = max(fastest, float(np.linalg.norm(physics.data.qvel[speed])))
    rests = physics.data.qpos[start : start + 3].copy()
    for _ in range(physics.steps_in(SECONDS[1])):
        physics.step()
    drift = float(np.linalg.norm(physics.data.qpos[start : start + 3] - rests))
    deepest = -float(physics.data.contact.dist[: physics.data.ncon].min(initial=0.0))
    return Pair(
        item=item,
        container=container,
        deepest=deepest,
        fastest=fastest if fits else 0.0,
        drift=drift,
        rolling=kinds[item].round or not fits,
    )


def _lowest_clear(physics: Physics, body: ObjectBody, container: ObjectBody) -> float:
    """How low the body's origin can be over the middle of a container without touching it [m]."""
    assert container.opening is not None
    data = mujoco.MjData(physics.model)
    data.qpos[:] = physics.data.qpos
    height = max(container.height, container.opening.rim) + LOWERED
    while height > container.opening.floor:
        data.qpos[body.qpos_address : body.qpos_address + 3] = (*PLACE, height - LOWERED)
        mujoco.mj_fwdPosition(physics.model, data)
        bodies = physics.model.geom_bodyid[data.contact.geom]
        if np.isin(bodies, body.parts).any():
            break
        height -= LOWERED
    return height


def _object(name: str, place: tuple[float, float]) -> SceneObject:
    kind = kinds[name]
    return SceneObject(
        name=name,
        kind=name,
        colour=kind.colour,
        size=kind.entry().size,
        container=kind.container,
        position=(*place, 0.0),
        yaw=0.3,
    )
