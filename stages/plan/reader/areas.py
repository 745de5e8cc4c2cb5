"""Target areas: what is stated stays, the rest takes typical areas scaled to the flat."""

from collections.abc import Collection, Mapping

from apartgen.schemas.plan import AskedRoom, Link
from apartgen.stages.plan.reader.sense import sense
from apartgen.stages.plan.reader.vocabulary import Trait


def typical(rooms: list[AskedRoom], links: list[Link], labels: Mapping[str, Collection[str]]) -> dict[str, float]:
    """Typical area of every room, m², from its type, its traits and its doors."""
    data = sense()
    studio = not any(r.type == "bedroom" for r in rooms) and any(r.type == "bathroom" for r in rooms)
    masters = [r.id for r in rooms if r.type == "bedroom" and "master" in labels.get(r.id, ())]
    first = next(iter(masters), next((r.id for r in rooms if r.type == "bedroom"), ""))
    beds = sum(r.type == "bedroom" for r in rooms)
    ranks = {r.id: nth for nth, r in enumerate(r for r in rooms if r.type == "bedroom" and r.id != first)}
    usual = data["area"] | {kind: by[min(beds, len(by) - 1)] for kind, by in data["by_bedrooms"].items()}
    out: dict[str, float] = {}
    for room in rooms:
        traits = set(labels.get(room.id, ()))
        traits |= {"first"} if room.id == first and not traits & {Trait.SMALL, Trait.KIDS, Trait.GUEST} else set()
        traits |= {"private"} if room.private_to else set()
        traits |= {"studio"} if studio and "loft" not in traits else set()
        named = [data["area_of"][key] for t in sorted(traits) if (key := f"{room.type}:{t}") in data["area_of"]]
        by_rank = data["by_rank"]["bedroom"]
        ranked = by_rank[min(ranks[room.id], len(by_rank) - 1)] if room.id in ranks else usual[room.type]
        out[room.id] = min(named) if named else ranked
        if room.type == "hallway":
            doors = sum(room.id in pair for pair in links)
            out[room.id] = data["hallway"]["base"] + data["hallway"]["per_door"] * doors
    return out


def fill(
    rooms: list[AskedRoom],
    base: dict[str, float],
    stated: Mapping[str, float],
    shares: Mapping[str, float],
    total: float | None,
) -> dict[str, float]:
    """Area of every room: `stated` and `shares` of the total are kept, the others scale to fit `total`."""
    kind = {r.id: r.type for r in rooms}
    fixed = dict(stated)
    shares = {i: share for i, share in shares.items() if share > 0}
    part = min(sum(v for k, v in shares.items() if k not in fixed), 0.95)
    free = [r.id for r in rooms if r.id not in fixed and r.id not in shares]
    if total is None:
        known = sum(fixed.values()) + sum(base[i] for i in free)
        whole = known / (1 - part) if known else sum(base[i] for i in shares) / part  # "15 % pantry" and no more
    else:
        whole = total
    fixed |= {i: share * whole for i, share in shares.items() if i not in fixed}
    scaled = {i: base[i] for i in free}
    if total is not None and free:
        scaled = _scaled(scaled, kind, max(total - sum(fixed.values()), 0.0))
    return {r.id: round(fixed[r.id] if r.id in fixed else scaled[r.id], 2) for r in rooms}


def _scaled(base: dict[str, float], kind: Mapping[str, str], wanted: float) -> dict[str, float]:
    """Bisection for the scale at which stretched areas, not below their least, add up to `wanted`."""
    data = sense()

    def at(scale: float) -> dict[str, float]:
        return {i: max(a * scale ** data["stretch"][kind[i]], min(a, data["least"][kind[i]])) for i, a in base.items()}

    low, high = 0.05, 20.0
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if sum(at(middle).values()) < wanted else (low, middle)
    return at((low + high) / 2)
