"""Clear of openings: nothing stands in a doorway, in a door's swing, or tall before a window."""

import torch
from torch import Tensor

from apartgen.stages.layout.geometry import Boxes, Floor, corners, meeting, obstructs, overlap_area


def energy(boxes: Boxes, room: Floor) -> Tensor:
    """Area of footprints in clear zones, m², summed over objects and zones."""
    top = boxes.center[..., 2] + boxes.size[..., 2] / 2
    bottom = boxes.center[..., 2] - boxes.size[..., 2] / 2
    counts = obstructs()[boxes.category][:, :, None] & (top[:, :, None] > room.zone_floor[:, None])
    counts &= (bottom < 2.0)[:, :, None] & (boxes.filled > 0)[:, :, None] & (room.zones[:, None, :, 0, 0] < 900)
    r, i, z = counts.nonzero().unbind(-1)
    footprints = corners(boxes)
    near = meeting(footprints[r, i], room.zones[r, z])
    r, i, z = r[near], i[near], z[near]
    return torch.zeros(len(boxes.center)).index_add(0, r, overlap_area(footprints[r, i], room.zones[r, z]))
