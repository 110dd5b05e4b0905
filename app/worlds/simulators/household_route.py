"""The way through a home: by which doors one point of its floor is reached from another."""

from collections import deque

from app.worlds.simulators.household_layout import HomeLayout

Spot = tuple[float, float]
"""x, y along the floor [m]."""


def doors_between(layout: HomeLayout, here: Spot, there: Spot) -> list[Spot]:
    """The middles of the doors from one point to the other, the fewest there are."""
    start, end = _room_at(layout, here), _room_at(layout, there)
    came: dict[int, tuple[int, Spot]] = {}
    waiting = deque([start])
    while waiting and end not in came and start != end:
        room = waiting.popleft()
        for door in layout.doors:
            ends = layout.graph.ids(door, "BETWEEN")
            for other in ends - {room} if room in ends else ():
                if other not in came and other != start:
                    x, y, _ = layout.solids[door.id].centre
                    came[other] = (room, (x, y))
                    waiting.append(other)
    path: list[Spot] = []
    while end != start and end in came:
        end, door_place = came[end]
        path.insert(0, door_place)
    return path


def _room_at(layout: HomeLayout, point: Spot) -> int:
    for room in layout.rooms:
        solid = layout.solids[room.id]
        if all(abs(point[k] - solid.centre[k]) <= solid.size[k] / 2 for k in (0, 1)):
            return room.id
    return layout.rooms[0].id
