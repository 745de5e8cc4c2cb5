"""Tables of rooms in the manner of Markdown, written as lines: `| Kitchen | 9.5 |` under `Area (m²)` as an area."""

import re

_RULE = r"^\s*\|?\s*:?-{2,}:?\s*(?:\|\s*:?-{2,}:?\s*)*\|?\s*$"
"""The line between the head of a table and its rows; compiled when there is a table."""
_SQUARE = r"(?i)m²|m2|m\^2|sq\.? ?m|qm|square met(?:er|re)s|平方米|㎡"
_FEET = r"(?i)ft²|ft2|sq\.? ?ft|square feet"
_FACED = r"(?i)^(?:faces|facing|orientation|aspect)$"
_COUNT = r"(?i)\b(?:count|number|qty|quantity|how many|anzahl|nombre|cantidad|no)\b|#|数量"
_NUMBER = r"\d+(?:[.,]\d+)?"
_HEAD = re.compile(
    r"(?=.*\b(?:m2|m²|sqm|sq ?ft|area|size|count|qty|number)(?![a-z]))(?:[^\d|]|m2)*(?:\|(?:[^\d|]|m2)*)+", re.I)
"""A row that names what stands below it."""


def without_tables(text: str) -> str:
    """A text as written with each row of a table as a line of its own."""
    lines = text.split("\n")
    if sum("|" in line for line in lines) < 2:
        return text
    out: list[str] = []
    head: list[str] = []
    for k, line in enumerate(lines):
        if "|" in line and k and "|" in lines[k - 1] and re.match(_RULE, line.strip()):
            head = _cells(out.pop())
        elif not head and _heads(line, "".join(lines[k + 1 : k + 2])):
            head = _cells(line)
        elif head and "|" in line:
            out.append(_row(head, _cells(line)))
        else:
            head = []
            out.append(line)
    return "\n".join(out)


def _heads(line: str, below: str) -> bool:
    """Whether a row names what stands below it, without a rule between them."""
    rows = "|" in line and "|" in below and not re.match(_RULE, below.strip())
    return rows and _HEAD.fullmatch(line.strip()) is not None


def _cells(line: str) -> list[str]:
    return [cell.strip() for cell in line.strip().strip("|").split("|")]


def _row(head: list[str], cells: list[str]) -> str:
    """`3 bedrooms.` or `Kitchen: 9.5 m², faces north.`, by what stands over the cells."""
    name, *rest = cells
    names = [*head[1:], *[""] * len(rest)]
    counts = [cell for cell, above in zip(rest, names, strict=False) if re.search(_COUNT, above) and cell.isdigit()]
    said = [_said(cell, above) for cell, above in zip(rest, names, strict=False) if not re.search(_COUNT, above)]
    told = ", ".join(part for part in said if part and part != "-")
    counted = f"{counts[0]} {_plural(name) if counts[0] != '1' else name}" if counts else name
    return f"{counted}: {told}." if told else f"{counted}."


def _plural(name: str) -> str:
    """An English name of several; others are the same in the lexicon's eyes when counted."""
    return f"{name}s" if re.search(r"(?:room|kitchen|hall(?:way)?|wc|toilet)$", name, re.IGNORECASE) else name


def _said(cell: str, above: str) -> str:
    """A cell with the unit or the verb that stands over it."""
    if re.search(_FACED, above) and cell.isalpha():
        return f"faces {cell}"
    unit = "m2" if re.search(_SQUARE, above) else "sqft" if re.search(_FEET, above) else ""
    return f"{cell} {unit}" if unit and re.fullmatch(_NUMBER, cell) else cell
