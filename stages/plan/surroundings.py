"""What stands about a flat: which sides have windows, and where one comes in.

A flat in a building has neighbours or the stair behind some of its sides. Where the programme leaves that open it is
drawn with the outline, so that the rooms that need daylight find enough façade.
"""

from collections.abc import Sequence
from math import sqrt

from numpy.random import Generator

from apartgen.schemas.plan import Envelope, Program, Side
from apartgen.stages.plan.blocks import OPPOSITE, SIDES
from apartgen.stages.plan.standards import STANDARDS
from apartgen.stages.plan.wishes import sunny

USUAL = (0.2, 0.5, 0.3)
"""Shares of flats with one, two and three façades, where their rooms allow it."""
CORNER = 0.5
"""Share of flats with two façades that stand at a corner of the building; the others go through it."""
SPARE = 1.35
"""Façade that a flat has, over what its rooms need."""
TRIES = 12
STUBBORN = 26
"""Draws that came to nothing after which a façade more is taken."""


def settled(envelope: Envelope) -> bool:
    """Whether all sides are as the programme says, so that nothing is drawn."""
    open_ = envelope.outline is None and envelope.dwelling != "house"
    return bool(envelope.party_walls) or envelope.facades == 4 or (envelope.facades is None and not open_)


def surrounded(program: Program, aspect: float, gross: float, failed: int, rng: Generator,
               overlooked: Sequence[tuple[Side, ...]] = ()) -> Envelope:
    """The envelope with party walls drawn where they are open.

    `aspect` is x over y of the outline and `gross` its area; `failed` counts earlier draws that admitted no plan. Of
    each of `overlooked` one side is free.
    """
    envelope = program.envelope
    if settled(envelope):
        return envelope
    most = 3 if failed < 2 * STUBBORN else 4
    needed = SPARE * front(program)
    long, free = sqrt(gross * aspect), list[Side]()
    for attempt in range(TRIES):
        number = envelope.facades or min(most, int(rng.choice(3, p=USUAL)) + 1 + failed // STUBBORN + attempt // 4)
        free = _sides(envelope, number, rng)
        if sum(long if side in ("south", "north") else gross / long for side in free) >= needed:
            break
    lit = {*free, *sunny(program)}
    lit |= {sides[0] for sides in overlooked if not lit & set(sides)}
    party = [side for side in SIDES if side not in lit]
    return envelope.model_copy(update={"party_walls": party, "facades": len(SIDES) - len(party)})


def front(program: Program) -> float:
    """Least façade that the rooms which need a window take side by side, m."""
    joined = {room for pair in program.open_links for room in pair}
    lit = [r for r in program.rooms if STANDARDS[r.base].lit and not (r.type == "kitchen" and r.id in joined)]
    norms = [(STANDARDS[r.base], r.area or STANDARDS[r.base].area) for r in lit]
    return sum(max(min(norm.width, sqrt(area)), sqrt(area / norm.aspect)) for norm, area in norms)


def _sides(envelope: Envelope, number: int, rng: Generator) -> list[Side]:
    """Sides with windows; of a house in a row the front and the back."""
    first = int(rng.integers(4))
    turned = [SIDES[(first + i) % 4] for i in range(4)]
    corner = envelope.dwelling == "corner_flat" or (envelope.dwelling == "flat" and rng.random() < CORNER)
    if number == 2 and not corner:
        return [turned[0], OPPOSITE[turned[0]]]
    return turned[:number]
