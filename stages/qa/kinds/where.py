"""In which room a picture was taken."""

import numpy as np

from apartgen.stages.qa.drafts import Draft, shared
from apartgen.stages.qa.facts import Facts
from apartgen.stages.qa.plain import could_be, in_its_room


def ask(facts: Facts, rng: np.random.Generator, most: int) -> list[Draft]:
    """Rooms by their types, of which the home may have several; what lies open to each other is not told apart, nor
    what might have all that is seen. Pictures all around are asked about in the same words as others, which are of some
    rooms more often.
    """
    drafts = []
    for view in facts.render.views:
        if view.kind in ("eye", "panorama") and view.room in facts.rooms and in_its_room(facts, view):
            answer = facts.type_of(view.room)
            joined = {name for name in map(facts.type_of, facts.rooms) if facts.joined([answer, name])}
            unfair = frozenset((joined | could_be(facts, view)) - {answer})
            drafts.append(Draft("In what room was this picture taken?", answer, [view.name], {"view": view.name},
                                barred=unfair))
    return shared(drafts, rng, most)
