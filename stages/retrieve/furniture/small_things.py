"""Small things, drawn part by part as their table says; every kind, style and size by one builder."""

from collections.abc import Callable
from typing import Any

import numpy as np

from apartgen.stages.retrieve.furniture import mesh
from apartgen.stages.retrieve.furniture.designs import design
from apartgen.stages.retrieve.furniture.kit import Kit
from apartgen.stages.retrieve.furniture.mesh import Array, Shape
from apartgen.stages.things import small
from apartgen.stages.things.asset import UNTURNED, Collider

_LAID = np.array([[1.0, 0, 0], [0, 0, 1], [0, -1, 0]])
"""Takes a thing onto its left side: its left (+y) becomes its underside."""
_SIDES = 16


class Frame:
    """The box that a thing is drawn in as it stands, and the turn into the box of the kit."""

    def __init__(self, kit: Kit) -> None:
        self.style, (self.d, self.w, self.h) = small.upright(kit.style, kit.size)
        self.lying = self.style != kit.style
        self.radius = min(self.d, self.w) / 2

    def corners(self, numbers: tuple[float, ...]) -> tuple[Array, Array]:
        """Least and greatest corner of shares x0, x1, y0, y1, z0, z1, m."""
        x0, x1, y0, y1, z0, z1 = numbers[:6]
        half = np.array([self.d / 2, self.w / 2, self.h])
        return half * [x0, y0, z0], half * [x1, y1, z1]

    def middle(self, numbers: tuple[float, ...]) -> Array:
        """Where the axis of something turned stands, m."""
        x, y = numbers[:2] if len(numbers) > 1 else (0.0, 0.0)
        return np.array([x * (self.d / 2 - self.radius), y * (self.w / 2 - self.radius), 0.0])

    def part(self, part: small.Part) -> Shape:
        """A part where it is in the kit's box."""
        name, _, *numbers = part
        made = _SHAPES[name](self, *numbers)
        return Shape(self.laid(made.vertices), made.faces, made.uv)

    def laid(self, points: Array) -> Array:
        """Points as the thing stands or lies, from the middle of its footprint."""
        if not self.lying:
            return points
        return np.asarray((points - [0, 0, self.h / 2]) @ _LAID.T + [0, 0, self.w / 2])


def _box(frame: Frame, *numbers: float) -> Shape:
    lo, hi = frame.corners(numbers)
    return mesh.prism([(lo[0], lo[1]), (hi[0], lo[1]), (hi[0], hi[1]), (lo[0], hi[1])], lo[2], hi[2])


def _sheet(frame: Frame, *numbers: float) -> Shape:
    """A box whose texture goes over its front once."""
    lo, hi = frame.corners(numbers)
    made = _box(frame, *numbers)
    return made._replace(uv=((made.vertices - lo) / (hi - lo))[:, 1:])


def _round(frame: Frame, *numbers: float) -> Shape:
    lo, hi = frame.corners(numbers)
    return mesh.rounded(lo, hi, numbers[6], 1)


def _pillow(frame: Frame, *numbers: float) -> Shape:
    lo, hi = frame.corners(numbers)
    return mesh.pillow(lo, hi, numbers[6], 5)


def _profile(frame: Frame, profile: Any, numbers: tuple[float, ...]) -> list[tuple[float, float]]:
    scale = numbers[2] if len(numbers) > 2 else 1.0
    return [(r * scale * frame.radius, z * frame.h) for r, z in profile]


def _turn(frame: Frame, profile: Any, *numbers: float) -> Shape:
    return mesh.lathe(_profile(frame, profile, numbers), _SIDES).moved(frame.middle(numbers))


def _pot(frame: Frame, profile: Any, wall: float, *numbers: float) -> Shape:
    outer = _profile(frame, profile, numbers)
    least = 0.03 * frame.radius
    inner = [(max(r - wall, least), z if z >= outer[-1][1] else z + wall) for r, z in outer]
    return mesh.lathe([*outer, *reversed(inner)], _SIDES, caps=False).moved(frame.middle(numbers))


def _bar(frame: Frame, path: Any, radius: float) -> Shape:
    return mesh.tube(np.asarray(path, float) * [frame.d / 2, frame.w / 2, frame.h], radius, 6)


_SHAPES: dict[str, Callable[..., Shape]] = {
    "box": _box, "sheet": _sheet, "round": _round, "pillow": _pillow, "turn": _turn, "pot": _pot, "bar": _bar,
}


def small_thing(kit: Kit) -> None:
    """The parts of its style in materials by its seed, and the collision pieces of its kind."""
    kind, frame = small.TABLE[kit.category], Frame(kit)
    worn = small.worn(kind, kit.seed)
    parts = kind.styles[frame.style]
    for (_, slot, *_), shape in zip(parts, _filling(kit, [frame.part(part) for part in parts]), strict=True):
        kit.base.show(worn[slot], shape)
    kit.base.colliders += [_collider(frame, piece) for piece in kind.collide]
    d, w, h = kit.size
    kit.friction = kind.friction
    kit.base.mass = small.mass(kind, (d, h, w) if frame.lying else (d, w, h))


def _filling(kit: Kit, shapes: list[Shape]) -> list[Shape]:
    """The shapes stretched by the last millimetres, so that they fill the kit's box."""
    points = np.concatenate([shape.vertices for shape in shapes])
    lo, hi, size = points.min(0), points.max(0), np.asarray(kit.size)
    corner = np.array([-kit.d / 2, -kit.w / 2, 0.0])
    return [Shape(corner + (shape.vertices - lo) * size / (hi - lo), shape.faces, shape.uv) for shape in shapes]


def _collider(frame: Frame, piece: tuple[Any, ...]) -> Collider:
    kind, *numbers = piece
    if kind == "box":
        lo, hi = (frame.laid(corner) for corner in frame.corners(tuple(numbers) or (-1, 1, -1, 1, 0, 1)))
        return Collider("box", (lo + hi) / 2, np.abs(hi - lo))
    x, y, scale, z0, z1 = numbers
    radius, low, high = scale * frame.radius, z0 * frame.h, z1 * frame.h
    center = frame.laid(frame.middle((x, y)) + [0, 0, (low + high) / 2])
    return Collider("cylinder", center, np.array([radius, radius, high - low]), _LAID if frame.lying else UNTURNED)


for _name in small.TABLE:
    design(_name, *small.styles(_name))(small_thing)
