"""Forty replies as models send them: each gives the typed programme, or a refusal that says what is wrong."""

import json
from typing import Any

import pytest

from apartgen.stages.plan.llm.answers import Broken, Declined, programme
from apartgen.stages.plan.llm.model import Answer

TYPES = ("living_room", "kitchen", "bedroom", "bathroom", "hallway")
FLAT: dict[str, Any] = {
    "rooms": [{"id": f"{kind}_1", "type": kind, "area": None, "private_to": None} for kind in TYPES],
    "links": [["hallway_1", f"{kind}_1"] for kind in TYPES[:4]],
}


def flat(**changes: Any) -> dict[str, Any]:
    return {**FLAT, **changes}


def reply(**changes: Any) -> str:
    return json.dumps({"program": flat(**changes), "refusal": None})


def asked(**row: Any) -> str:
    return reply(requirements=[{"id": "asked_1", "of": "kitchen_1", "to": None, "value": None, "text": ""} | row])


GOOD = [
    reply(),
    json.dumps(FLAT),  # the programme alone
    json.dumps({"program": FLAT}),
    json.dumps({"program": FLAT, "refusal": None}, indent=2),
    f"```json\n{reply()}\n```",
    f"```\n{reply()}\n```",
    f"Here is the programme you asked for:\n\n{reply()}\n\nLet me know if anything should change.",
    f"<think>The user wants {{one bedroom}}, so five rooms.</think>\n{reply()}",
    f"Using the format {{\"a\": 1}} is not needed. {reply()}",
    "\ufeff" + reply(),
    "   \n\t" + reply(),
    reply() + reply(),  # said twice
    reply(total_area=55),
    reply(total_area="55"),
    reply(open_links=[["hallway_1", "living_room_1"]]),
    reply(objects=[{"room": "bedroom_1", "category": "desk", "count": 2}]),
    asked(kind="position", value="north_west"),
    asked(kind="adjacent", to="bathroom_1"),
    asked(kind="near", to="entrance", met=True),
    asked(kind="dimension", value="3.5 x 4"),
    asked(kind="at_most", value=12),
]  # fmt: skip
BROKEN = [
    ("", "empty"),
    ("  \n ", "empty"),
    ("A flat with five rooms.", "no JSON"),
    (reply()[: len(reply()) // 2], "JSON is broken"),
    (reply().replace('"', "'"), "JSON is broken"),
    (reply(rooms=[]), "rooms"),
    (reply(rooms="five"), "rooms"),
    (reply(rooms=[{"id": "cave_1", "type": "cave"}]), "rooms"),
    (reply(rooms=[{"id": "bedroom_1", "type": "kitchen"}], links=[]), "begin with the type"),
    (reply(links=[["hallway_1", "attic_1"]]), "attic_1"),
    (reply(links=[["hallway_1", "hallway_1"]]), "itself"),
    (reply(objects=[{"room": "bedroom_1", "category": "throne", "count": 1}]), "throne"),
    (reply(mood="cosy"), "mood"),
    (asked(kind="beside", to="bathroom_1"), "beside"),
    (asked(kind="position", value="upstairs"), "upstairs"),
    (asked(kind="adjacent"), "another room"),
    (asked(kind="adjacent", to="attic_1"), "attic_1"),
    (asked(kind="dimension", value="big"), "big"),
]
DECLINED = ["I'm sorry, I can't help with that.", json.dumps({"program": None, "refusal": "no home"})]


@pytest.mark.parametrize("text", GOOD)
def test_good_replies_are_the_programme(text: str) -> None:
    program = programme(Answer(text))
    assert [r.type for r in program.rooms] == list(TYPES) and len(program.links) == 4
    assert all(r.met is None for r in program.requirements)


def test_areas_that_are_given_are_asked_for() -> None:
    rooms = [room | {"area": area} for room, area in zip(FLAT["rooms"], (24, 9.5, 12, None, None), strict=True)]
    rows = [{"id": "asked_2", "kind": "at_least", "of": "bedroom_1", "to": None, "value": 12, "text": ""},
            {"id": "asked_3", "kind": "near", "of": "kitchen_1", "to": "entrance", "text": ""}]  # fmt: skip
    found = programme(Answer(reply(rooms=rooms, requirements=rows))).requirements
    assert [(r.id, r.kind, r.of, r.value) for r in found[2:]] == [
        ("asked_1", "area", "living_room_1", "24"), ("asked_4", "area", "kitchen_1", "9.5")]  # fmt: skip


@pytest.mark.parametrize(("text", "named"), BROKEN)
def test_bad_replies_say_what_is_wrong(text: str, named: str) -> None:
    with pytest.raises(Broken, match=named):
        programme(Answer(text))


@pytest.mark.parametrize("text", DECLINED)
def test_refusals_are_the_models(text: str) -> None:
    with pytest.raises(Declined):
        programme(Answer(text))


@pytest.mark.parametrize("length", [199, 200, 201, 400])
def test_reasons_are_lines_of_at_most_200_signs(length: int) -> None:
    with pytest.raises(Declined) as told:
        programme(Answer("", refusal="x" * length))
    said = str(told.value)
    assert said == ("x" * length if length <= 200 else "x" * 199 + "…")
