"""Scores a round of prompts with programmes: `python tests/sentences/rounds.py round.jsonl [--each]`.

A line of a round is one of the benchmark (`sentences.jsonl`) that may have more: `requirements` (`kind`, `of`, `to`,
`value` as in a programme), `objects` (`room`, `category`, `count`) and `unread`, words of which each is to be told. A
prompt is right when its rooms, doors, openings, stated areas, requirements and objects are those of the line, under one
naming of rooms of a type, and nothing that is to be told is lost. What is told beside that is counted apart.
`--each` shows what differs, prompt by prompt.
"""

import argparse
import json
import logging
import math
import sys
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field
from itertools import islice, permutations
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).parents[1]))

from apartgen.schemas.errors import ApartgenError  # noqa: E402
from apartgen.schemas.plan import Program  # noqa: E402
from apartgen.stages.plan.reader import read  # noqa: E402
from apartgen.stages.plan.reader.areas import typical  # noqa: E402
from apartgen.stages.plan.reader.lexicon import read_lexicon  # noqa: E402
from apartgen.stages.plan.reader.tokens import fold  # noqa: E402
from apartgen.stages.space import graphs  # noqa: E402
from sentences import case_of  # noqa: E402

MUTUAL = ("adjacent", "apart", "opposite", "no_door")
LIMITS = ("at_least", "at_most")
NEAR = 0.03
"""Part by which numbers may differ."""
READER = ("area", "scaled", "ratio")
"""Facts that a programme has of all rooms, said or not."""
LARGER, SMALLER = 1.15, 0.9
"""What a large and what a small room has at least and at most, of the typical area."""
NAMINGS = 50_000
Row = dict[str, Any]
Facts = dict[str, list[tuple[Any, ...]]]


@dataclass
class Score:
    """What became of one prompt: `lost` and `added` are facts by kind, under the naming with fewest of both."""

    id: int
    node: float = 0.0
    edge: float = 0.0
    error: str = ""
    lost: list[str] = field(default_factory=list)
    added: list[str] = field(default_factory=list)
    untold: list[str] = field(default_factory=list)
    needless: list[str] = field(default_factory=list)

    @property
    def right(self) -> bool:
        """All as written, nothing lost in silence."""
        return not (self.error or self.lost or self.added or self.untold)


def scored(row: Row) -> Score:
    """The score of a line."""
    case, score = case_of(row), Score(row["id"])
    logging.getLogger("apartgen").setLevel(logging.CRITICAL)
    try:
        program = read(row["prompt"])
    except ApartgenError as error:
        refused = row.get("refused", False)
        return Score(row["id"], float(refused), float(refused), "" if refused else str(error))
    graph = graphs.of_program(program)
    score.node, score.edge = graphs.node_similarity(graph, case.truth), graphs.edge_similarity(graph, case.truth)
    score.lost, score.added = _compared(row, program)
    told = [_plain(words) for words in program.unread]
    wanted = [_plain(words) for words in row.get("unread", [])]
    score.untold = [w for w in wanted if not any(_shares(w, t) for t in told)]
    score.needless = [t for t in told if not any(_shares(w, t) for w in wanted)]
    return score


def _plain(words: str) -> str:
    return fold(words).partition("(")[0].strip() or fold(words)


def _shares(wanted: str, told: str) -> bool:
    return bool(set(wanted.split()) & set(told.split())) or wanted in told or told in wanted


def _compared(row: Row, program: Program) -> tuple[list[str], list[str]]:
    """Facts lost and added, under the naming of rooms with the fewest."""
    truth = _written(row)
    told = {*row.get("traits", {}), *row.get("areas", {})}
    given = {r.id: r.type for r in program.rooms}
    best: tuple[list[str], list[str]] | None = None
    for names in islice(_namings(row["rooms"], list(given)), NAMINGS):
        found = _read(program, names, told)
        found["asked"] = [q for q in found["asked"] if q in truth["asked"] or not _implied(q, truth["door"])]
        found["object"] = [o for o in found["object"] if o in truth["object"] or not _slept_in(o, given)]
        found["total"] = [t for t in found["total"] if truth["total"] or not _aimed_at(t, found["asked"])]
        lost = [f"{k} {f}" for k in truth for f in _without(truth[k], found[k])]
        added = [f"{k} {f}" for k in truth if k not in READER for f in _without(found[k], truth[k])]
        added = [fact for fact in added if not (fact.startswith("object ") and fact.endswith(", 0)"))]  # "not a tub"
        if best is None or len(lost) + len(added) < len(best[0]) + len(best[1]):
            best = lost, added
        if not lost and not added:
            break
    assert best is not None
    return best


def _aimed_at(total: tuple[float], asked: list[tuple[Any, ...]]) -> bool:
    """Whether a home of which only limits were told is planned within them: what it aims at is no further fact."""
    limits = [(kind, float(value)) for kind, of, to, value in asked if of == "home" and kind in LIMITS and not to]
    above = all(total[0] >= value for kind, value in limits if kind == "at_least")
    return bool(limits) and above and all(total[0] <= value for kind, value in limits if kind == "at_most")


def _namings(rooms: list[str], ids: list[str]) -> Iterator[dict[str, str]]:
    """All ways to give the rooms read the names of those written, type by type."""
    types = sorted({i.rsplit("_", 1)[0] for i in ids})
    own = {t: [i for i in ids if i.rsplit("_", 1)[0] == t] for t in types}
    theirs = {t: [r for r in rooms if r.rsplit("_", 1)[0] == t] for t in types}
    for t in types:
        theirs[t] += [f"{t}?{k}" for k in range(len(own[t]) - len(theirs[t]))]
    yield from _named([(own[t], theirs[t]) for t in types])


def _named(types: list[tuple[list[str], list[str]]]) -> Iterator[dict[str, str]]:
    """The namings of each type with those of the types after it, one at a time: ten rooms of a type have millions."""
    if not types:
        yield {}
        return
    (own, theirs), *others = types
    for names in permutations(theirs, len(own)):
        for rest in _named(others):
            yield dict(zip(own, names, strict=True)) | rest


def _pair(a: str, b: str) -> tuple[str, str]:
    return (a, b) if a < b else (b, a)


def _value(value: Any) -> str:
    """`4.0 x 3` as `4 x 3`."""
    parts = str(value if value is not None else "").split(" x ")
    numbers = [f"{float(p):.3g}" if p.replace(".", "", 1).isdigit() else p for p in parts]
    return " x ".join(sorted(numbers) if len(numbers) > 1 else numbers)


def _asked(kind: str, of: str, to: str | None, value: Any) -> tuple[Any, ...]:
    a, b = _pair(of, to or "") if kind in MUTUAL and to and to != "entrance" else (of, to or "")
    return kind, a, b, _value(value)


def _written(row: Row) -> Facts:
    """The facts of a line."""
    opened = [_pair(a, b) for a, b in row.get("open_links", [])]
    return {
        "room": [(r,) for r in row["rooms"]],
        "door": sorted({_pair(a, b) for a, b in row["links"]} | set(opened)),
        "opening": opened,
        "area": [(r, float(a)) for r, a in row.get("areas", {}).items()],
        "total": [(float(row["total_area"]),)] if row.get("total_area") else [],
        "scaled": [
            (r, "small" if "small" in traits else "large")
            for r, traits in row.get("traits", {}).items()
            if {"large", "small", "long"} & set(traits) and r not in row.get("areas", {})
        ],
        "ratio": [(a, b, float(n)) for a, b, n in row.get("ratios", [])],
        "asked": [_asked(q["kind"], q["of"], q.get("to"), q.get("value")) for q in row.get("requirements", [])],
        "object": [(o["room"], _category(o["category"]), o.get("count", 1)) for o in row.get("objects", [])],
    }


def _read(program: Program, names: dict[str, str], told: set[str]) -> Facts:
    """The facts of a programme under a naming; of the rooms `told` of, areas say nothing of the others."""
    named = {**names, "home": "home", "entrance": "entrance"}
    opened = [_pair(names[a], names[b]) for a, b in program.open_links]
    areas = [(names[r.id], float(r.area or 0)) for r in program.rooms]
    return {
        "room": [(names[r.id],) for r in program.rooms],
        "door": sorted({_pair(names[a], names[b]) for a, b in program.links} | set(opened)),
        "opening": opened, "area": areas, "scaled": _scaled(program, names, told),
        "ratio": [(a, b, m / n) for (a, m), (b, n) in permutations(areas, 2)],
        "total": [(float(program.total_area),)] if program.total_area else [],
        "asked": [_asked(q.kind, named[q.of], named.get(q.to or "", q.to), q.value) for q in program.requirements
                  if q.kind != "area"],
        "object": [(names[o.room], o.category, o.count) for o in program.objects],
    }  # fmt: skip


def _category(word: str) -> str:
    """What the project calls a piece of furniture."""
    readings = read_lexicon().entries.get(tuple(word.replace("_", " ").replace("-", " ").lower().split())) or ()
    return next((r.value for r in readings if r.kind == "furniture"), word.lower().replace(" ", "_"))


def _scaled(program: Program, names: dict[str, str], told: set[str]) -> list[tuple[Any, ...]]:
    """Rooms that are large or small beside the others of their home, for what they are."""
    usual = typical(program.rooms, program.links, {})
    factors = {r.id: (r.area or 0.0) / usual[r.id] for r in program.rooms}
    plain = sorted(f for r, f in factors.items() if names[r] not in told)
    middle = plain[len(plain) // 2] if plain else 1.0
    large = [(names[r], "large") for r, f in factors.items() if f >= LARGER * middle]
    return [*large, *((names[r], "small") for r, f in factors.items() if f <= SMALLER * middle)]


def _implied(asked: tuple[Any, ...], doors: list[tuple[Any, ...]]) -> bool:
    """Whether rooms that are to be neighbours are so by a door between them."""
    return asked[0] == "adjacent" and _pair(asked[1], asked[2]) in doors


def _slept_in(thing: tuple[Any, ...], given: dict[str, str]) -> bool:
    """Whether this is the bed that a home without a bedroom gets unsaid."""
    return thing[1] == "double_bed" and "bedroom" not in given.values()


def _without(some: list[tuple[Any, ...]], others: list[tuple[Any, ...]]) -> list[tuple[Any, ...]]:
    """Those of `some` that are not among `others`, numbers within a part."""
    left, out = list(others), []
    for fact in some:
        same = next((other for other in left if _same(fact, other)), None)
        if same is None:
            out.append(fact)
        else:
            left.remove(same)
    return out


def _same(a: tuple[Any, ...], b: tuple[Any, ...]) -> bool:
    return len(a) == len(b) and all(
        math.isclose(x, y, rel_tol=NEAR) if isinstance(x, float) and isinstance(y, float) else x == y
        for x, y in zip(a, b, strict=True))


def table(scores: list[Score]) -> str:
    """The figures of a round."""
    n = len(scores)
    silent = Counter(kind for s in scores for kind in {f.split()[0] for f in [*s.lost, *s.added]})
    return (
        f"prompts {n}, S_node {sum(s.node for s in scores) / n:.4f}, S_edge {sum(s.edge for s in scores) / n:.4f}, "
        f"right {sum(s.right for s in scores)} ({sum(s.right for s in scores) / n:.3f}), "
        f"of these with needless words told {sum(s.right and bool(s.needless) for s in scores)}; "
        f"rooms alone right {sum(s.node == 1 for s in scores)}, refused {sum(bool(s.error) for s in scores)}, "
        f"lost in silence {sum(bool(s.untold) for s in scores)}; wrong by kind {dict(silent)}"
    )


def main() -> None:
    """Prints a round's figures."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("rounds", nargs="+", type=Path)
    parser.add_argument("--each", action="store_true", help="show what differs, prompt by prompt")
    given = parser.parse_args()
    for path in given.rounds:
        rows = [json.loads(line) for line in path.read_text(encoding="utf-8").splitlines() if line.strip()]
        scores = [scored(row) for row in rows]
        print(f"{path.name}: {table(scores)}")
        for row, score in zip(rows, scores, strict=True):
            if given.each and (not score.right or score.needless):
                print(f"\n{row['id']} {'RIGHT' if score.right else 'WRONG'} {row['prompt']}")
                for name in ("error", "lost", "added", "untold", "needless"):
                    print(*([f"    {name}: {getattr(score, name)}"] if getattr(score, name) else []))


if __name__ == "__main__":
    main()
