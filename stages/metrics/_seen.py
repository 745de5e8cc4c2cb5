"""Image metrics over sets of rooms: features of their pictures, generated against real and real against real."""

from collections.abc import Callable, Sequence

import numpy as np

from apartgen.schemas.layout import Layout
from apartgen.schemas.metrics import Value
from apartgen.stages.metrics._distances import LEAST, RESAMPLES, Figure, Sample
from apartgen.stages.metrics._networks import Network
from apartgen.stages.metrics._pictures import PIXELS, picture
from apartgen.stages.metrics._sets import ALL, SEED, halves, rooms, types

Distance = Callable[[Sample, Sample, np.random.Generator], Figure]


def note(network: Network) -> str:
    """How the figures came about, for people."""
    return (
        f"{', '.join(name + network.suffix for name in ('FID', 'KID', 'SCA'))}: features of {network.name}; "
        f"rooms drawn as boxes from above, {PIXELS}² pixels, openings left out; `generated` and `real` (one half of "
        f"the real rooms) each against the other half, n scenes a side; 95 % intervals of {RESAMPLES} resamples, "
        f"seed {SEED}"
    )


def between(
    name: str, distance: Distance, homes: Sequence[Layout], real: Sequence[Layout], network: Network, unit: str = ""
) -> list[Value]:
    """One figure in all rooms of the real rooms' types, and by type; None where there are too few scenes."""
    values = []
    for kind in (ALL, *types(real)):
        drawn, reference, other = halves(rooms(homes, real, kind), rooms(real, real, kind))
        for version, side in (("generated", drawn), ("real", other)):
            found = Value(name=name + network.suffix, value=None, unit=unit, version=version, of=kind, n=len(side))
            if len(side) >= LEAST:
                a, b = (network.features([picture(r.polygon, inside, r.base) for r, inside in some])
                        for some in (side, reference))
                figure = distance(a, b, np.random.default_rng(SEED))
                found = found.model_copy(update=figure._asdict())
            values.append(found)
    return values
