"""Shape: what an asset looks like and what of it collides, as it is stored."""

import io
from dataclasses import dataclass
from typing import NamedTuple, TypeVar

import numpy as np
from numpy.typing import NDArray

from app.worlds.simulators.mujoco.colours import Colour
from app.worlds.simulators.mujoco.shapes import Mesh, Points

Number = TypeVar("Number", bound=np.generic)


class Look(NamedTuple):
    """A surface that is seen."""

    mesh: Mesh
    colour: Colour | None = None
    """Its own, where it has one; else the object's."""


class Primitive(NamedTuple):
    """A ball, box or the like that collides, as MuJoCo has it."""

    type: int
    """Of ``mujoco.mjtGeom``."""
    size: tuple[float, float, float]
    """By type [m]."""
    centre: tuple[float, float, float]
    """[m]"""
    turn: tuple[float, float, float, float]
    """Quaternion wxyz."""


@dataclass(frozen=True, slots=True, eq=False)
class Shape:
    """Everything in the object's frame: z up, origin under the middle of the object."""

    looks: tuple[Look, ...]
    parts: tuple[Points, ...] = ()
    """The corners of what is convex and collides, each (n, 3) [m]."""
    primitives: tuple[Primitive, ...] = ()

    def pack(self) -> bytes:
        """As it is stored: a compressed archive of arrays."""
        file = io.BytesIO()
        none = (np.nan,) * 4
        np.savez_compressed(
            file,
            vertices=np.concatenate([look.mesh.vertices for look in self.looks]).astype(np.float32),
            faces=np.concatenate([look.mesh.faces for look in self.looks]).astype(np.int32),
            looks=np.array([(len(m.vertices), len(m.faces)) for m, _ in self.looks], np.int32),
            colours=np.array([look.colour or none for look in self.looks], np.float32),
            corners=np.concatenate([np.zeros((0, 3)), *self.parts]).astype(np.float32),
            counts=np.array([len(part) for part in self.parts], np.int32),
            types=np.array([each.type for each in self.primitives], np.int32),
            primitives=np.array(
                [(*each.size, *each.centre, *each.turn) for each in self.primitives], np.float64
            ).reshape(-1, 10),
        )
        return file.getvalue()

    @classmethod
    def unpack(cls, packed: bytes) -> "Shape":
        """What ``pack`` gave; also of before there were looks and primitives."""
        with np.load(io.BytesIO(packed), allow_pickle=False) as found:
            vertices, faces = found["vertices"].astype(float), found["faces"]
            parts = _split(found["corners"].astype(float), found["counts"])
            if "looks" not in found:
                return cls((Look(Mesh(vertices, faces)),), parts)
            points, triangles = found["looks"].T
            meshes = map(Mesh, _split(vertices, points), _split(faces, triangles))
            colours = map(_colour, found["colours"].tolist())
            rows = zip(found["types"].tolist(), found["primitives"].tolist(), strict=True)
            primitives = tuple(
                Primitive(kind, tuple(row[:3]), tuple(row[3:6]), tuple(row[6:]))
                for kind, row in rows
            )
            return cls(tuple(map(Look, meshes, colours)), parts, primitives)


def _split(rows: NDArray[Number], counts: NDArray[np.int32]) -> tuple[NDArray[Number], ...]:
    return tuple(np.split(rows, np.cumsum(counts)[:-1])) if len(counts) else ()


def _colour(stored: list[float]) -> Colour | None:
    red, green, blue, alpha = stored
    return None if np.isnan(red) else (red, green, blue, alpha)
