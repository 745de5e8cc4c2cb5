"""What carries an object, as its artifact says; told from its category and where it is only when nobody said."""

from collections.abc import Collection, Sequence
from typing import TypeVar

from apartgen.schemas import carrying
from apartgen.schemas.carrying import BUILDING, Body
from apartgen.schemas.layout import Box, Layout
from apartgen.stages.things.categories import TABLE

AnyBox = TypeVar("AnyBox", bound=Box)
AnyHome = TypeVar("AnyHome", bound=Layout)


def recorded(home: AnyHome) -> AnyHome:
    """The apartment with `on` of every object said."""
    return home.model_copy(update={"objects": told(home.objects, home.height)})


def told(objects: Sequence[AnyBox], height: float) -> list[AnyBox]:
    """The objects of an apartment that high, m, with `on` of every one said."""
    bodies = [_body(o) for o in objects]
    return [o if o.on is not None else o.model_copy(update={"on": carrying.carrier(body, bodies, height)})
            for o, body in zip(objects, bodies, strict=True)]


def carried(o: Box, objects: Collection[AnyBox]) -> list[AnyBox]:
    """What stands on an object, and on that in turn."""
    near = [p for p in objects if p.on == o.id]
    return [q for p in near for q in (p, *carried(p, objects))]


def by_another(o: Box) -> bool:
    """Whether an object stands on another one; by its kind where nobody said."""
    return _place(o) == "top" if o.on is None else o.on not in BUILDING


def holds(below: Box, o: Box) -> bool:
    """Whether an object is where another can carry it."""
    return carrying.over(_body(o), _body(below))


def _body(o: Box) -> Body:
    return Body(o.id, o.room, _place(o), o.center, o.size, o.yaw)


def _place(o: Box) -> str:
    return TABLE[o.category].place if o.category in TABLE else ""
