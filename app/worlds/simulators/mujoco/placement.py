"""Completing a scene: every object described, and standing somewhere the robot can use it."""

from dataclasses import dataclass, replace

import numpy as np

from app.domain.errors import Fault, SceneRefused
from app.domain.scene import Position, Scene, SceneObject
from app.worlds.simulators.mujoco.arms import DEFAULT_ARM, arms
from app.worlds.simulators.mujoco.description import describe
from app.worlds.simulators.mujoco.footprint import Footprint, first_free, gaps
from app.worlds.simulators.mujoco.objects import kinds

MAX_OBJECTS = 40
REACH = (0.30, 0.65)
"""How near to and how far from the robot's base an object's middle may be [m]."""
SECTOR = 1.30
"""How far to the left or right of straight ahead it may be [rad]."""
BASE_RADIUS = 0.17
"""What the foot of the arm and its elbow take; nothing reaches into it [m]."""
TALL = 0.045
"""From this height on an object is in the way of a hand that picks what is beside it [m]."""
FACING = 0.25
"""What has a front faces the robot up to this [rad]."""
_PLACES = 2
"""Keeps the stream of random numbers for places apart from others of the same seed."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Layout:
    """How close objects may stand and how far to the sides."""

    gap: float
    """To leave between low objects [m]."""
    beside_tall: float
    """To leave beside a tall one [m]."""
    sector: float
    """To either side of straight ahead [rad]."""
    candidates: int
    closest: bool
    """Take the free place closest to others, not the first, to leave more room for the rest."""


LAYOUTS = (
    Layout(gap=0.045, beside_tall=0.085, sector=0.90, candidates=48, closest=False),
    Layout(gap=0.035, beside_tall=0.060, sector=1.00, candidates=64, closest=False),
    Layout(gap=0.030, beside_tall=0.040, sector=1.15, candidates=96, closest=True),
    Layout(gap=0.020, beside_tall=0.022, sector=1.29, candidates=144, closest=True),
)
"""From generous to crowded."""


def complete(scene: Scene, seed: int) -> Scene:
    """The scene with everything its client left open filled in; the same seed, the same scene.

    The robot is the usual one if none is named. Kinds come from names; sizes, places and yaws that are not given are drawn. What is given is
    kept. Completing a completed scene changes nothing.

    Raises:
        SceneRefused: it cannot be built; every fault names its field.
    """
    if message := _count_fault(len(scene.objects)):
        raise SceneRefused(Fault(field="scene.objects", message=message))
    entropy = seed % 2**63
    faults = _name_clashes(scene)
    if scene.environment is not None:
        message = "the tabletop has no ready-made environments; leave it out and list objects"
        faults.append(Fault(field="scene.environment", message=message))
    if scene.graph is not None:
        message = "the tabletop takes no home of one's own; leave it out, or world='household'"
        faults.append(Fault(field="scene.graph", message=message))
    robot = scene.robot or DEFAULT_ARM
    if robot not in arms:
        message = f"there is no robot {robot[:40]!r}; there is {', '.join(arms)}"
        faults.append(Fault(field="scene.robot", message=message))
    objects: list[SceneObject] = []
    for index, item in enumerate(scene.objects):
        described, found = describe(item, entropy, index)
        objects.append(described)
        faults += found
    faults += _place_faults(objects, {fault.field for fault in faults})
    if faults:
        raise SceneRefused(*faults)
    return replace(scene, objects=_placed(objects, entropy), robot=robot)


def _count_fault(count: int) -> str | None:
    if count == 0:
        return "is empty; list at least one object, like {'name': 'banana'}"
    if count > MAX_OBJECTS:
        return f"lists {count:,} objects; a table takes at most {MAX_OBJECTS}"
    return None


def _name_clashes(scene: Scene) -> list[Fault]:
    first: dict[str, int] = {}
    faults: list[Fault] = []
    for index, name in enumerate(scene.names):
        if first.setdefault(name, index) != index:
            message = f"is also the name of object {first[name] + 1} of the list; every name must be its own"
            faults.append(Fault(field=f"scene.objects.{index}.name", message=message))
    return faults


def _place_faults(objects: list[SceneObject], wrong: set[str]) -> list[Fault]:
    """What is wrong with the places given; objects whose size or yaw is wrong are left out."""
    faults: list[Fault] = []
    standing: list[tuple[str, Footprint]] = []
    for index, item in enumerate(objects):
        where = f"scene.objects.{index}"
        if item.position is None:
            continue
        message = _reach_fault(item.position)
        if message is None and not {f"{where}.size", f"{where}.yaw"} & wrong:
            footprint = _footprint(item, item.position, item.yaw or 0.0)
            message = _overlap(footprint, standing)
            standing.append((item.name, footprint))
        if message:
            faults.append(Fault(field=f"{where}.position", message=message))
    return faults


def _reach_fault(position: Position) -> str | None:
    x, y, z = position
    if not np.isfinite(position).all():
        return "is not made of numbers; give metres, like [0.5, 0.2], or leave it out"
    near, far = REACH
    distance, bearing = float(np.hypot(x, y)), float(np.arctan2(y, x))
    if not near <= distance <= far or abs(bearing) > SECTOR:
        return (
            f"is out of reach, {distance:.2f} m from the robot's base and {np.degrees(bearing):.0f} "
            f"degrees to its left; it reaches {near:.2f} to {far:.2f} m, up to "
            f"{np.degrees(SECTOR):.0f} degrees to either side of straight ahead (x)"
        )
    if abs(z) > 1e-3:
        return f"is {z:.3f} m above the table; every object starts on it, at z = 0"
    return None


def _overlap(footprint: Footprint, standing: list[tuple[str, Footprint]]) -> str | None:
    for name, other in standing:
        gap = float(gaps(footprint, other)[0, 0])
        if gap < 0:
            return (
                f"overlaps {name[:40]!r} by {-gap:.3f} m; move them apart, "
                "or leave the position out and a free one is found"
            )
    return None


def _footprint(item: SceneObject, position: Position, yaw: float) -> Footprint:
    half, radius = _shape(item)
    return Footprint(
        centre=np.array([position[:2]]),
        yaw=np.array([yaw]),
        half=np.array([half]),
        radius=np.array([radius]),
    )


def _shape(item: SceneObject) -> tuple[tuple[float, float], float]:
    """Half extents of the footprint's core and the radius it is grown by [m]."""
    kind, size = kinds[item.kind or ""], item.size or (0.0, 0.0, 0.0)
    if kind.round:
        return (0.0, 0.0), size[0] / 2
    return kind.half_extents(size), 0.0


def _placed(objects: list[SceneObject], seed: int) -> tuple[SceneObject, ...]:
    """Everything in a place of its own, trying ever more crowded layouts.

    Raises:
        SceneRefused: there is not that much room on the table.
    """
    placed: dict[int, SceneObject] = {}
    for number, layout in enumerate(LAYOUTS):
        random = np.random.default_rng([seed, _PLACES, number])
        placed = _laid_out(objects, random, layout)
        if len(placed) == len(objects):
            return tuple(placed[index] for index in range(len(objects)))
    message = (
        f"do not fit on the table together: {len(placed)} of {len(objects)} do; leave some out"
    )
    raise SceneRefused(Fault(field="scene.objects", message=message))


def _laid_out(
    objects: list[SceneObject], random: np.random.Generator, layout: Layout
) -> dict[int, SceneObject]:
    """Objects with places, by index: those given, then of the others, large to small, what fits."""
    placed = {
        index: replace(item, yaw=item.yaw or 0.0)
        for index, item in enumerate(objects)
        if item.position is not None
    }
    taken = Footprint.none()
    for item in placed.values():
        taken = taken.joined(_footprint(item, item.position or (0, 0, 0), item.yaw or 0.0))
    tall = [_is_tall(item) for item in placed.values()]
    open_ones = [index for index in range(len(objects)) if index not in placed]
    for index in sorted(open_ones, key=lambda index: -_spread(objects[index])):
        item = objects[index]
        beside = np.where(np.array(tall, bool) | _is_tall(item), layout.beside_tall, layout.gap)
        candidates = _candidates(item, random, layout)
        chosen = first_free(candidates, taken, beside, closest=layout.closest)
        if chosen is None and layout is not LAYOUTS[-1]:
            break  # the next layout may do; only the last one counts what fits
        if chosen is None:
            continue
        spot = candidates[chosen]
        taken = taken.joined(spot)
        tall.append(_is_tall(item))
        x, y = (float(value) for value in spot.centre[0])
        placed[index] = replace(item, position=(x, y, 0.0), yaw=float(spot.yaw[0]))
    return placed


def _candidates(item: SceneObject, random: np.random.Generator, layout: Layout) -> Footprint:
    """Places in reach for an object, evenly spread over the area in front of the robot."""
    half, radius = _shape(item)
    near = max(REACH[0], BASE_RADIUS + _spread(item)) + 0.002
    share, bearing, turn = random.random((3, layout.candidates))
    distance = np.sqrt(near**2 + share * ((REACH[1] - 0.002) ** 2 - near**2))
    bearing = (2 * bearing - 1) * layout.sector
    if item.yaw is not None:
        yaw = np.full(len(turn), item.yaw)
    elif kinds[item.kind or ""].faces:
        yaw = bearing + (2 * turn - 1) * FACING
    else:
        yaw = (2 * turn - 1) * np.pi
    return Footprint(
        centre=np.column_stack([distance * np.cos(bearing), distance * np.sin(bearing)]).round(4),
        yaw=yaw if item.yaw is not None else yaw.round(4),
        half=np.tile(half, (len(turn), 1)),
        radius=np.full(len(turn), radius),
    )


def _spread(item: SceneObject) -> float:
    """From the footprint's centre to its farthest point [m]."""
    half, radius = _shape(item)
    return float(np.hypot(*half)) + radius


def _is_tall(item: SceneObject) -> bool:
    return item.size is not None and item.size[2] > TALL
