"""How far a thing comes forward once a part is fully open."""

import numpy as np

from apartgen.schemas.retrieve import Furnishing
from apartgen.stages.qa.drafts import Draft, shared
from apartgen.stages.qa.facts import Facts, centimetres
from apartgen.stages.qa.plain import LEVEL, hides_how
from apartgen.stages.space import sweeps

LEAST = 0.1


def ask(facts: Facts, rng: np.random.Generator, most: int) -> list[Draft]:
    """Measured from its closed front to the foremost point of any of its parts, each opened as far as it goes; of
    doors alone, or drawers alone, of which one is not taken for the other.
    """
    drafts = []
    for it in facts.marked:
        o = facts.objects[it.id]
        if not isinstance(o, Furnishing):
            continue
        joints = [joint for joint in o.joints if joint.extent]
        if len({(joint.type, abs(joint.axis[2]) > LEVEL) for joint in joints}) != 1:
            continue
        out = max((float(sweeps.moved(joint, joint.range[1])[1][0]) for joint in joints), default=0.0) - o.size[0] / 2
        if out > LEAST and facts.fine(it) and not hides_how(o):
            text = f"All parts of {it} are fully opened. How far do they stand out before its closed front?"
            evidence = {"object": it.id, "metres": round(out, 3)}
            drafts.append(facts.numbered(it.view, text, centimetres(out), evidence, number=out, hard=1))
    return shared(drafts, rng, most)
