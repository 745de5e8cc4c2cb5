"""Col_obj, Col_scene: objects whose box stands in another's, and scenes that have any."""

from apartgen.schemas.layout import Layout
from apartgen.schemas.metrics import Value
from apartgen.schemas.plan import Plan, Program
from apartgen.stages.metrics._pairs import Rule, standing_in
from apartgen.stages.metrics._shares import shares, solid
from apartgen.stages.space import boxes
from apartgen.stages.space.boxes import TOLERANCE

NEEDS = Layout
STRICT = 1e-6
"""Depth above which boxes that merely touch do not count, m."""


def measure(home: Plan, against: Plan | Program | None = None) -> list[Value]:
    """Versions: ours = deeper than 1 cm, without pairs that belong together · strict = the same at 0 ·
    grouped = deeper than 1 cm, all pairs · published = PhyScene's `rotated_bbox`: all pairs, any overlap.
    """
    things = solid(home)
    rules = {"ours": Rule(TOLERANCE, False), "strict": Rule(STRICT, False), "grouped": Rule(TOLERANCE, True),
             "published": Rule(STRICT, True)}
    values = []
    for version, hit in standing_in(things, boxes.of(things), rules).items():
        values += shares(home, "Col_obj", version, hit, things)
        by_room = {o.room: False for o in things} | {o.room: True for o, met in zip(things, hit, strict=True) if met}
        values += [Value(name="Col_scene", value=float(any_), unit="scene", version=version, of=of)
                   for of, any_ in {"apartment": bool(hit.any()), **by_room}.items()]
    return values
