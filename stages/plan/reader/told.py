"""What a door that is told says of the others: which stand beside a room's usual doors, and which in their place."""

from typing import TYPE_CHECKING

from apartgen.stages.plan.reader.statements import Statement
from apartgen.stages.plan.reader.vocabulary import Det, Relation

if TYPE_CHECKING:
    from apartgen.stages.plan.reader.doors import Doors, Pair

WAYS_IN = frozenset("off from through via behind beyond over".split())
"""Last words of what tells how one comes into a room."""
DOORS = ("door", "doors")
TABLE = {"kitchen", "dining_room"}


def in_passing(s: Statement, pairs: list["Pair"], out: "Doors") -> None:
    """Adds to `out` the doors of `s` that leave a kitchen its usual one, and the rooms whose way in it tells.

    `a dining room with doors to kitchen and lounge` tells no way into the kitchen; `the kitchen opens onto the dining
    room` does, and so does `the hall leads to bedroom, bath and kitchen, the kitchen to the lounge` of the lounge.
    """
    if s.kind not in (Relation.DOOR, Relation.OPEN, Relation.NEAR, Relation.ONLY):
        return
    words = s.relation.split()
    way_in = s.kind == Relation.ONLY or words[-1:] and words[-1] in WAYS_IN
    for a, b in pairs:
        noun = any(word in DOORS for word in words) and not way_in
        out.passing += [(a, b)] if "dining_room" in (a.type, b.type) and noun else []
        listed = (noun or words == ["to"]) and (a.type, b.type) == ("kitchen", "dining_room")
        out.near += [(a, b)] if listed else []  # "the kitchen has doors to the hall and to the dining room"
        out.reached += [a] if way_in and (a.type, b.type) == ("living_room", "kitchen") else []
    halls = [p.type == "hallway" for p in s.left]
    listed = s.kind == Relation.DOOR and bool(halls) and all(halls) and len(s.right) > 1
    if listed and not any(p.type in ("any", "living_room") or p.quantifier == Det.ALL for p in s.right):
        out.reached += [b for a, b in pairs if b.type == "kitchen"]  # what it leads to is entered there


def beside_usual(out: "Doors") -> None:
    """Of a dining room that has a door to the lounge or the kitchen, the way to the kitchen is one of two."""
    tables = {id(e) for pair in out.passing for e in pair if e.type == "dining_room"}
    out.passing = [p for p in out.links if {e.type for e in p} == TABLE and tables & {id(e) for e in p}]
    listed = [e for e in out.reached if e.type == "kitchen"]
    out.reached += [b if a in listed else a for a, b in out.links if (a in listed) != (b in listed)]
