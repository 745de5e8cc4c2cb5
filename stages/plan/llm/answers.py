"""What a model is told, and how its reply becomes a programme or a nameable problem."""

import json
import re
from collections.abc import Iterator
from functools import cache
from itertools import count
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from apartgen.schemas.base import Record
from apartgen.schemas.plan import Program, Requirement
from apartgen.schemas.rooms import kinds
from apartgen.stages.plan.llm.model import Answer
from apartgen.stages.plan.reader.requirements import sizes
from apartgen.stages.things.categories import TABLE

TERMS = (
    "shortest_path", "typical_area", "aspect_ratio", "convexity", "conciseness", "exterior_length", "exterior_corner",
    "collinearity", "functional_room", "narrow_passage", "staircase_occupancy", "staircase_iou",
)  # fmt: skip
"""The solver's reward terms."""


PLACES = (
    "north", "south", "east", "west", "north_east", "north_west", "south_east", "south_west", "left", "right", "top",
    "bottom", "front", "back", "centre", "corner",
)  # fmt: skip
KINDS: dict[str, tuple[str, ...]] = {
    "position": PLACES, "orientation": PLACES[:8], "adjacent": (), "apart": (), "near": (), "opposite": (),
    "order": ("larger", "smaller", "largest", "smallest"), "dimension": ("<length> x <width>",),
    "area": ("<m²>",), "at_least": ("<m²>",), "at_most": ("<m²>",), "use": ("<type of room>",),
}  # fmt: skip
"""Kinds of requirements and their values; those without have another room or the entrance in `to`."""


class Reply(Record):
    """What a model sends: a programme, or why there is none."""

    program: Program | None = None
    refusal: str | None = None


class Broken(Exception):
    """A reply that is no valid programme; the text says what is wrong, for the model to correct."""


class Declined(Exception):
    """The model will not answer; the text is its reason."""


@cache
def instructions() -> str:
    """The system prompt: `prompt.md` with the vocabulary filled in."""
    text = (Path(__file__).parent / "prompt.md").read_text(encoding="utf-8")
    text = text.replace("{types}", ", ".join(kinds()))
    text = text.replace("{requirements}", "; ".join(f"{kind} {' | '.join(v)}".strip() for kind, v in KINDS.items()))
    return text.replace("{categories}", ", ".join(TABLE)).replace("{terms}", ", ".join(TERMS))


@cache
def reply_schema() -> dict[str, Any]:
    """JSON Schema of a reply; types of room are those that are known here."""
    schema = Reply.model_json_schema()
    room = schema["$defs"]["AskedRoom"]
    del room["anyOf"], room["properties"]["like"]
    room["properties"]["type"]["enum"] = list(kinds())
    return schema


def programme(answer: Answer) -> Program:
    """The programme in a reply. Raises Declined or Broken."""
    if answer.refusal:
        raise Declined(_line(answer.refusal))
    if not answer.text.strip():
        raise Broken("the reply is empty")
    raw = _object(answer)
    raw = raw if "program" in raw or "refusal" in raw else {"program": raw}
    strange = sorted(set(raw["program"]) - set(Program.model_fields)) if isinstance(raw.get("program"), dict) else []
    if strange:
        raise Broken(f"program has no field {', '.join(strange)}; what no field can say belongs into unread")
    try:
        reply = Reply.model_validate(raw)
    except ValidationError as e:
        raise Broken(_first_errors(e)) from e
    if reply.program is None:
        raise Declined(_line(reply.refusal or "no reason given"))
    problems = faults(reply.program)
    if problems:
        raise Broken("; ".join(problems[:6]))
    asked = [r.model_copy(update={"met": None}) for r in reply.program.requirements]
    return reply.program.model_copy(update={"requirements": [*asked, *_areas(reply.program)]})


def _areas(program: Program) -> Iterator[Requirement]:
    """Areas of rooms, which are null where the description says none, as what is asked of them."""
    sized, used = {r.of for r in program.requirements if sizes(r.kind, r.to)}, {r.id for r in program.requirements}
    numbers = (n for n in count(1) if f"asked_{n}" not in used)
    for room in program.rooms:
        if room.area is not None and room.id not in sized:
            yield Requirement(id=f"asked_{next(numbers)}", kind="area", of=room.id, value=f"{room.area:g}")


def faults(program: Program) -> list[str]:
    """Contradictions inside a programme that its types do not rule out, in words."""
    ids = [r.id for r in program.rooms]
    known = set(ids)
    out = [f"rooms holds the id {i} twice" for i in sorted({i for i in ids if ids.count(i) > 1})]
    out += [
        f"room {r.id} is of type {r.type}; its id must begin with the type"
        for r in program.rooms
        if r.id.rsplit("_", 1)[0] != r.type
    ]
    named = [("links", i) for pair in program.links for i in pair] + [
        ("open_links", i) for pair in program.open_links for i in pair
    ]
    named += [("objects", o.room) for o in program.objects] + [("counts", i) for i in program.counts]
    named += [("private_to", r.private_to) for r in program.rooms if r.private_to]
    out += [f"{where} names {i}, which is not in rooms" for where, i in dict.fromkeys(named) if i not in known]
    out += [fault for r in program.requirements for fault in _requirement(r, known)]
    out += [f"links joins {a} to itself" for a, b in program.links if a == b]
    out += [
        f"objects names the unknown category {c}"
        for c in sorted({o.category for o in program.objects} - TABLE.keys())
    ]
    out += [f"weights names the unknown term {w}" for w in sorted(set(program.weights) - set(TERMS))]
    out += [
        f"counts gives {n} objects to {i}; 0 to 60 are possible" for i, n in program.counts.items() if not 0 <= n <= 60
    ]
    return out


def _requirement(asked: Requirement, known: set[str]) -> Iterator[str]:
    """What is wrong with one requirement."""
    where, value = f"requirement {asked.id}", str(asked.value)
    if asked.kind not in KINDS:
        yield f"{where} is of the unknown kind {asked.kind}"
        return
    if asked.of not in known | {"home"}:
        yield f"{where} is of {asked.of}, which is not in rooms"
    if asked.to is not None and asked.to not in known | {"entrance"}:
        yield f"{where} names {asked.to}, which is not in rooms"
    values = KINDS[asked.kind]
    shape = {"<length> x <width>": r"\d+(\.\d+)? x \d+(\.\d+)?", "<m²>": r"\d+(\.\d+)?", "<type of room>": "[a-z_]+"}
    fits = not values or value in values or any(re.fullmatch(shape.get(v, "(?!)"), value) for v in values)
    if not fits or (not values and asked.to is None):
        yield f"{where} of kind {asked.kind} needs {' | '.join(values) or 'another room'}, not {value}"


def _object(answer: Answer) -> dict[str, Any]:
    """The first JSON object in the reply's text, which may stand in prose or a code block."""
    start = answer.text.find("{")
    if start < 0:
        if answer.cut_off:
            raise Broken("the reply was cut off before any JSON")
        raise (
            Declined(_line(answer.text)) if _sounds_declining(answer.text) else Broken("the reply holds no JSON object")
        )
    try:
        raw = _decoded(answer.text, start)
    except json.JSONDecodeError as e:
        why = (
            "the reply was cut off; be brief, leave out whitespace"
            if answer.cut_off
            else f"the JSON is broken: {e.msg} at character {e.pos}"
        )
        raise Broken(why) from e
    except RecursionError as e:
        raise Broken("the JSON is nested too deep") from e
    return raw


def _decoded(text: str, start: int) -> dict[str, Any]:
    """The first object that is a reply, as models think aloud in braces, too; else the one at `start`."""
    found = [m.start() for m in re.finditer(r"\{(?=\s*\"(?:program|refusal|rooms)\")", text)]
    raw, _ = json.JSONDecoder().raw_decode(text[found[0] if found else start :])
    return dict(raw)


def _sounds_declining(text: str) -> bool:
    words = text.lower().replace("’", "'")
    return any(w in words for w in ("i can't", "i cannot", "i'm sorry", "i am sorry", "unable to", "i won't"))


def _first_errors(e: ValidationError) -> str:
    rows = e.errors(include_url=False, include_input=False)[:5]
    return "; ".join(f"{'.'.join(str(p) for p in row['loc'])}: {row['msg']}" for row in rows)


def _line(text: str) -> str:
    short = " ".join(text.split())
    return short if len(short) <= 200 else short[:199] + "…"
