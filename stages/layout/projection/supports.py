"""Places on top of furniture: a lamp on a nightstand, a television on its stand."""

from dataclasses import replace

import numpy as np

from apartgen.stages.layout.projection.costs import SOFT
from apartgen.stages.layout.projection.standing import Item
from apartgen.stages.space.boxes import Boxes, penetration
from apartgen.stages.things.categories import TABLE

EDGE = 0.01
"""From the front edge of what carries it, m: where a hand gets to what is used or switched."""


def on_support(item: Item, others: list[Item]) -> Item | None:
    """On the nearest support that it belongs on, wholly over its top and clear of what stands there already."""
    supports = [o for o in others if o.category in TABLE[item.category].belongs]
    for support in sorted(supports, key=lambda o: float(np.linalg.norm(o.center[:2] - item.center[:2]))):
        fitting = np.maximum(np.minimum(item.size, [*support.size[:2], np.inf]), TABLE[item.category].min)
        item, room = replace(item, size=fitting), support.size[:2] - fitting[:2]
        if (room < 0).any():
            continue
        c, s = np.cos(support.yaw), np.sin(support.yaw)
        offset = np.array([[c, s], [-s, c]]) @ (item.center[:2] - support.center[:2])
        half = np.maximum(room / 2, 0)
        centred = TABLE[item.category].stands.centred
        if centred:
            offset[1] = 0.0
        z = support.center[2] + support.size[2] / 2 + item.size[2] / 2
        for share in (None, 0.0, 0.5, -0.5, 1.0, -1.0):
            at = np.clip(offset, -half, half) if share is None else np.array([-half[0] * 0.6, half[1] * share])
            if not centred and not TABLE[support.category].kneehole:  # there the front edge is for the arms
                at[0] = max(half[0] - EDGE, at[0])
            place = support.center[:2] + np.array([[c, -s], [s, c]]) @ at
            stood = replace(item, center=np.array([*place, z]), yaw=support.yaw, cost=0.0)
            if all(not _touch(stood, o) for o in others if o is not support and o.category not in SOFT):
                return stood
    return None


def _touch(a: Item, b: Item) -> bool:
    one, two = (Boxes(o.center[None], o.size[None], np.array([o.yaw])) for o in (a, b))
    return bool(penetration(one, two)[0, 0] > 0.004)


