"""Bodies with some of their parts open."""

from collections.abc import Mapping, Sequence
from dataclasses import replace

from apartgen.stages.space import sweeps
from apartgen.stages.things.asset import Link
from apartgen.stages.things.body import Body


def moved(link: Link, share: float) -> Link:
    """What shows of a link, its joint at this share of its range."""
    joint = link.joint
    if joint is None or share == 0:
        return link
    value = joint.range[0] + share * (joint.range[1] - joint.range[0])
    shown = [replace(mesh, vertices=sweeps.at(joint, mesh.vertices, value)) for mesh in link.visuals]
    return replace(link, visuals=shown)


def ajar(bodies: Sequence[Body], shares: Mapping[str, float]) -> list[Body]:
    """The bodies; all joints of those that are named, at this share of their ranges."""
    return [_open(body, shares[body.name]) if body.name in shares else body for body in bodies]


def _open(body: Body, share: float) -> Body:
    return replace(body, links=[moved(link, share) for link in body.links])
