"""What a programme says, in short: `B2 H K L W`, `K1L1` a door, `K1~L1` no wall, `B1=12` m², `near K1 entrance`."""

from collections.abc import Callable, Mapping, Sequence

import pytest

from apartgen.schemas.plan import Program
from apartgen.stages.plan.reader import read

SHORT = {
    "living_room": "L", "kitchen": "K", "dining_room": "D", "bedroom": "B", "bathroom": "W", "hallway": "H",
    "study": "S", "utility": "U", "storage": "T", "closet": "C", "balcony": "Y",
}  # fmt: skip


def rooms(program: Program) -> str:
    """How many rooms of each type, in alphabetical order."""
    kinds = [SHORT[room.base] for room in program.rooms]
    return " ".join(f"{k}{kinds.count(k)}" if kinds.count(k) > 1 else k for k in sorted({*kinds}))


def facts(program: Program) -> set[str]:
    """All else: doors, openings, areas, requirements, furniture, and words that are told of as `unread …`."""
    asked = [[r.kind, _short(r.of), r.to and _short(r.to), r.value] for r in program.requirements]
    out = [" ".join(str(part) for part in one if part is not None) for one in asked]
    out += ["".join(sorted((_short(a), _short(b)))) for a, b in program.links]
    out += ["~".join(sorted((_short(a), _short(b)))) for a, b in program.open_links]
    out += [f"{_short(room.id)}={room.area:g}" for room in program.rooms if room.area is not None]
    out += [f"all={program.total_area:g}"] if program.total_area else []
    out += [f"{_short(o.room)} has {o.count} {o.category}" for o in program.objects]
    return {*out, *(f"unread {entry.split(' (')[0]}" for entry in program.unread)}


def as_meant(rows: Sequence[tuple[str, str, str]]) -> Callable[[str, str, str], None]:
    """The test that prompts have these rooms, say these facts (a list with commas), and none of those behind a `!`."""

    @pytest.mark.parametrize(("prompt", "wanted", "told"), rows)
    def test(prompt: str, wanted: str, told: str) -> None:
        program = read(prompt)
        said, entries = facts(program), told.split(", ") if told else []
        missing = {entry for entry in entries if entry[0] != "!"} - said
        found = rooms(program), missing, {entry[1:] for entry in entries if entry[0] == "!"} & said
        assert found == (wanted, set(), set()), found

    return test


def however_said(said: Mapping[tuple[str, str], Sequence[str]]) -> Callable[[tuple[str, str], str], None]:
    """The test that all prompts of a list have the rooms and the facts before it, and that nothing of them is told."""

    rows = [(key, prompt) for key, prompts in said.items() for prompt in prompts]

    @pytest.mark.parametrize(("wanted", "prompt"), rows)
    def test(wanted: tuple[str, str], prompt: str) -> None:
        program = read(prompt)
        found, entries = facts(program), wanted[1].split(", ") if wanted[1] else []
        missing = {entry for entry in entries if entry[0] != "!" and not set(entry.split(" or ")) & found}
        denied = {entry[1:] for entry in entries if entry[0] == "!"} & found
        assert (rooms(program), missing, denied, program.unread) == (wanted[0], set(), set(), [])

    return test


def _short(of: str) -> str:
    kind, _, number = of.rpartition("_")
    return SHORT[kind] + number if kind in SHORT else of
