"""What types of room are furnished with: their facts, once it is known that there are such categories and uses."""

from functools import cache

from apartgen.schemas.errors import BadInput, near
from apartgen.schemas.rooms import RoomKind, kinds, told
from apartgen.stages.things.categories import TABLE


@cache
def furnishing(type: str) -> RoomKind:
    """The facts of a type of room; BadInput where they name a category or a use that there is not."""
    kind = kinds()[type]
    uses = {use: 0 for category in TABLE.values() for use in category.uses}
    for fact, named, there, what in (("objects", kind.objects, TABLE, "category"), ("keeps", kind.keeps, uses, "use")):
        if strange := [name for name in named if name not in there]:
            raise BadInput(told(type, f"{fact}: {strange[0]!r} is no {what}; {near(strange[0], there)}"))
    return kind
