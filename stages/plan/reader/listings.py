"""Numbers without units: counts and areas by where they stand in a list, and numbers in a row."""

from dataclasses import replace

from apartgen.stages.plan.reader.lexeme import Lexeme

NONE = ("none", "no", "0", "zero", "nil")
"""`Balcony: none`."""

ABOUT = ("about", "roughly", "around", "approximately", "approx", "circa", "ca", "some")

JOINTS = {
    "-": "-",
    "to": "-",
    "and": "and",
    ",": "and",
    "/": "and",
    "und": "and",
    "et": "and",
    "y": "and",
    "bis": "-",
}


def numbers_joined(words: list[Lexeme], i: int) -> tuple[list[float], list[str], int]:
    """Numbers from `i` on, what stands between them, and where they end."""
    numbers: list[float] = []
    joints: list[str] = []
    j = i
    while j < len(words) and words[j].kind == "number":
        numbers.append(words[j].number)
        j += 1
        if j < len(words) and words[j].kind == "number" and words[j].joined:
            joints.append("-")
        elif j + 1 < len(words) and words[j + 1].kind == "number" and words[j].text in JOINTS:
            joints.append(JOINTS[words[j].text])
            j += 1
        else:
            break
    return numbers, joints, j


def paired_off(words: list[Lexeme]) -> list[Lexeme]:
    """`living 22 kitchen 8 bath 4`: a comma behind each number of a list that has none, as they belong to what is
    before them."""
    out: list[Lexeme] = []
    i = 0
    while i < len(words):
        end = i
        while end + 1 < len(words) and words[end].kind == "room" and words[end + 1].kind == "number":
            end += 2
        begins = not out or out[-1].kind == "mark"
        ends = end == len(words) or words[end].kind in ("mark", "conjunction")
        if begins and ends and end - i > 4:
            pairs = [words[k : k + 2] for k in range(i, end, 2)]
            out += [w for pair in pairs for w in (*pair, Lexeme("mark", ",", ","))][:-1]
            i = end
        else:
            out.append(words[i])
            i += 1
    return out


def bare(words: list[Lexeme]) -> list[Lexeme]:
    """`38 m² in all, 12 for the bedroom`: once areas are spoken of, a number for a room is one."""
    if not any(w.kind == "area" for w in words):
        return words
    out = _of_each(words)
    for i in range(len(out) - 3):
        number, joint, article, room = out[i : i + 4]
        for_the = joint.text == "for" and article.kind == "determiner" and room.kind == "room" and not room.plural
        if number.kind == "number" and for_the and number.number >= 3:
            out[i] = replace(number, kind="area", value="", values=(number.number,))
    for i in range(1, len(out)):
        if _said_to_be(out, i):
            out[i] = replace(out[i], kind="area", value="", values=(out[i].number,))
    return out


BETWEEN = ("between", "entre", "zwischen")


def bare_limits(words: list[Lexeme]) -> list[Lexeme]:
    """`the bath at least 6 m² and the kitchen between 8 and 10`: once areas are spoken of, limits of rooms are some."""
    if not any(w.kind == "area" for w in words):
        return words
    out: list[Lexeme] = []
    i = 0
    while i < len(words):
        size = _limit_size(words, i, out) if out else 0
        values = tuple(w.number for w in words[i : i + size] if w.kind == "number")
        text = " ".join(w.text for w in words[i : i + size])
        out.append(Lexeme("area", "", text, values=values) if size else words[i])
        i += size or 1
    return out


def _limit_size(words: list[Lexeme], i: int, out: list[Lexeme]) -> int:
    """How many words the number or the two numbers of a room's limit without a unit take at `i`; 0 where none stand."""
    between = out[-1].text in BETWEEN
    if not between and (out[-1].reading("bound") or out[-1]).kind != "bound":
        return 0
    values, joints, _ = numbers_joined(words[: i + 3], i) if words[i].text[0].isdigit() else ([], [], i)
    size = 3 if between and len(values) == 2 and joints == ["and"] else 1 if values and not between else 0
    ends = i + size >= len(words) or words[i + size].kind in ("mark", "conjunction", "boundary")
    of_room = any(w.kind == "room" for w in out[-6:]) and not any(w.kind in ("furniture", "area") for w in out[-3:])
    return size if ends and of_room and all(2 <= value <= 60 for value in values[: 1 + between]) else 0


def sized_anew(words: list[Lexeme]) -> list[Lexeme]:
    """`we said ten square metres, no, let's make it twelve`: an area, where one of about that size was said last."""
    out = list(words)
    for k in range(1, len(words)):
        ends = k + 1 >= len(words) or words[k + 1].kind in ("mark", "conjunction", "boundary")
        said = next((w for w in reversed(out[: k - 1]) if w.kind in ("area", "room")), None)
        alike = words[k].kind == "number" and said is not None and said.kind == "area"
        if alike and said is not None and words[k - 1].kind == "anew" and ends:
            fits = 0.5 <= words[k].number / said.values[0] <= 2
            out[k] = replace(words[k], kind="area", value="", values=(words[k].number,)) if fits else words[k]
    return out


def _said_to_be(words: list[Lexeme], i: int) -> bool:
    """Whether the number of `the big one is 16 m² and the small one 11` is an area: it counts nothing."""
    plain = words[i].kind == "number" and words[i].text[0].isdigit() and 3 <= words[i].number <= 60
    ends = i + 1 >= len(words) or words[i + 1].kind in ("mark", "conjunction", "boundary")
    verb = words[i - 1].text in ("is", "has", "measures", "of", "ist", "hat", "est", "mide", "tiene", "mesure", "fait")
    of = words[max(i - 1 - verb, 0)]
    said = of.kind in ("room", "size", "ordinal", "label") or of.text == "one"
    return plain and ends and said and (verb or of.kind == "size" or (of.text == "one" and words[i - 2].kind == "size"))


def _of_each(words: list[Lexeme]) -> list[Lexeme]:
    """`a kitchen of 14 and bedrooms of 16, 12 and 11`."""
    out: list[Lexeme] = []
    i = 0
    while i < len(words):
        about = i + 1 + (words[i + 1 : i + 2] != [] and words[i + 1].text in ABOUT)
        values, joints, end = numbers_joined(words, about) if words[i].text == "of" else ([], [], i)
        plain = bool(out) and out[-1].kind == "room" and set(joints) <= {"and"} and min(values, default=0) >= 3
        if plain and not out[-1].plural:
            values, end = values[:1], about + 1
        if plain and (end >= len(words) or words[end].kind in ("mark", "conjunction", "negation", "link")):
            out.append(Lexeme("area", "", " ".join(w.text for w in words[about:end]), values=tuple(values)))
            i = end
        else:
            out.append(words[i])
            i += 1
    return out


def _each_in_brackets(words: list[Lexeme]) -> list[Lexeme]:
    """`3 bedrooms (12/12/16)`, `2 BA (4, 6)` as areas of each."""
    out: list[Lexeme] = []
    i = 0
    while i < len(words):
        values, joints, end = numbers_joined(words, i + 1) if words[i].text == "(" else ([], [], i)
        closed = len(values) > 1 and set(joints) == {"and"} and end < len(words) and words[end].text == ")"
        if closed and out and out[-1].kind in ("room", "shorthand"):
            out.append(made(values, words, i + 1, end))
            i = end + 1
        else:
            out.append(words[i])
            i += 1
    return out


def listing(words: list[Lexeme]) -> list[Lexeme]:
    """`Bedrooms: 3` and `bedrooms (3)` are counts, `kitchen (10)` is an area."""
    out = _each_in_brackets(words)
    in_brackets = [c.number for a, b, c in zip(words, words[1:], words[2:], strict=False) if _bracketed(a, b, c)]
    areas = sum(n > 3 for n in in_brackets) > 1
    for i in range(len(out) - 2):
        room, mark, number = out[i : i + 3]
        closed = i + 3 >= len(out) or out[i + 3].kind in ("mark", "conjunction")
        counted = i and out[i - 1].kind in ("number", "determiner")  # "three bedrooms - no, two"
        if room.kind == "room" and mark.text in (":", "-") and closed and number.text in NONE and not counted:
            out[i : i + 3] = [replace(number, kind="negation", value="no"), room, replace(mark, kind="stop", value="")]
            continue
        if room.kind != "room" or mark.text not in ("(", ":", "-", "x", "*") or number.kind != "number" or not closed:
            continue
        if room.plural or (number.number <= 3 and number.number % 1 == 0 and not (areas and mark.text == "(")):
            out[i : i + 3] = [number, room, replace(mark, kind="stop", value="", text=",")]
        elif number.number >= 1:
            out[i + 2] = Lexeme("area", "", number.text, values=(number.number,))
    return out


def _bracketed(room: Lexeme, mark: Lexeme, number: Lexeme) -> bool:
    return room.kind == "room" and not room.plural and mark.text == "(" and number.kind == "number"


def made(values: list[float], words: list[Lexeme], i: int, j: int) -> Lexeme:
    return Lexeme("area", "", " ".join(w.text for w in words[i:j]), values=tuple(values), joined=words[i].joined)


def counted_behind(words: list[Lexeme]) -> list[Lexeme]:
    """`rugs: two in the lounge, one in each bedroom`: so many of what is named before."""
    out: list[Lexeme] = []
    thing: Lexeme | None = None
    for k, word in enumerate(words):
        number, inside = [*words[k + 1 : k + 3], *[Lexeme("mark", ".", ".")] * 2][:2]
        if word.text == ":" and out and out[-1].kind == "furniture" and _so_many(number, inside):
            thing = out.pop()
        elif thing is not None and _so_many(word, number):
            out += [word, thing]
        else:
            thing = None if word.value == "." else thing
            out.append(word)
    return out


def _so_many(number: Lexeme, inside: Lexeme) -> bool:
    return number.kind == "number" and inside.kind == "with" and inside.value == "in"
