"""Inside the room: no corner of a box, nor of what its parts sweep, lies beyond the walls."""

from torch import Tensor

from apartgen.stages.layout.geometry import Boxes, Floor, corners, outside


def energy(boxes: Boxes, room: Floor) -> Tensor:
    """Mean distance of corners outside, metres, summed over objects."""
    points = corners(boxes.extended())
    b, n = points.shape[:2]
    far = outside(points.flatten(1, 2), room).view(b, n, 4)
    return (far.mean(-1) * boxes.filled).sum(-1)
