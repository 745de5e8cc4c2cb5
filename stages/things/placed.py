"""A placed asset as its artifact has it, which says how far parts open; the asset must be the one that it tells of."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from apartgen.schemas.errors import BadInput
from apartgen.schemas.retrieve import Furnishing, Joint
from apartgen.stages.things.asset import Asset, Link

CLOSE = 1e-4
"""Lengths and angles that differ by no more are the same, m and rad; artifacts hold rounded ones."""


def links(o: Furnishing, asset: Asset) -> list[Link]:
    """The asset's links, each part with the range that the artifact gives it.

    BadInput where the artifact has another size or other joints than the asset, or a range that does not open.
    """
    if not _close(o.size, asset.size):
        raise _unlike(o, "size", str(list(o.size)), str(list(asset.size)))
    made = asset.joints
    if len(o.joints) != len(made):
        raise _unlike(o, "joints", _names(o.joints), _names(made))
    for k, (given, joint) in enumerate(zip(o.joints, made)):
        for field in ("name", "type", "part", "axis", "origin"):
            if not _same(given, joint, field):
                there, here = (str(getattr(one, field)) for one in (given, joint))
                raise _unlike(o, f"joints[{k}].{field}", there, here)
        if given.range[0] >= given.range[1]:
            raise BadInput(f"object {o.id}: its joints[{k}].range {list(given.range)} is empty; give [least, greatest]")
    ranges = {joint.name: given.range for given, joint in zip(o.joints, made) if not _close(given.range, joint.range)}
    return [_opening(link, ranges) for link in asset.links] if ranges else asset.links


def _opening(link: Link, ranges: dict[str, tuple[float, float]]) -> Link:
    if link.joint is None or link.joint.name not in ranges:
        return link
    return replace(link, joint=link.joint.model_copy(update={"range": ranges[link.joint.name]}))


def _same(a: Joint, b: Joint, field: str) -> bool:
    if field == "origin" and b.type == "hinge":  # anywhere on its axis
        off = np.subtract(a.origin, b.origin)
        return not off.any() or _close(np.cross(b.axis, off).tolist(), (0, 0, 0))
    if field == "origin":
        return True
    if field == "axis":
        return _close(a.axis, b.axis)
    return bool(getattr(a, field) == getattr(b, field))


def _close(a: Sequence[float], b: Sequence[float]) -> bool:
    return all(abs(x - y) <= CLOSE for x, y in zip(a, b, strict=True))


def _names(joints: Sequence[Joint]) -> str:
    return ", ".join(joint.name for joint in joints) or "none"


def _unlike(o: Furnishing, field: str, there: str, here: str) -> BadInput:
    return BadInput(
        f"object {o.id}: its {field} ({there}) is not its asset's ({here}, {o.asset.library}/{o.asset.id}); "
        "choose assets anew with `apartgen retrieve`, or write the asset's own"
    )
