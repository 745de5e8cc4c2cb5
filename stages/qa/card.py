"""What a folder of questions holds, as a page that data sets' hubs read: README.md with a head of settings."""

from collections import Counter
from collections.abc import Mapping, Sequence
from typing import Any

from apartgen.stages import registry

Row = Mapping[str, Any]

MARK = "<!-- written by apartgen qa, which replaces this page -->"
SIZES = ((1_000, "n<1K"), (10_000, "1K<n<10K"), (100_000, "10K<n<100K"), (1_000_000, "100K<n<1M"))
LARGEST = "n>1M"
HEAD = """---
pretty_name: Questions about furnished homes
language:
- en
task_categories:
- visual-question-answering
- multiple-choice
size_categories:
- {size}
tags:
- synthetic
- indoor
- spatial-reasoning
configs:
- config_name: default
  data_files: "*.jsonl"
dataset_info:
  features:
  - name: messages
    list:
    - name: role
      dtype: string
    - name: content
      dtype: string
{columns}
  - name: marks
    sequence:
      sequence: int64
  - name: evidence
    struct:
{evidence}
---
"""
COLUMNS = {"images": True, "videos": True, "id": False, "kind": False, "text": False, "options": True, "answer": False,
           "value": False, "difficulty": False}
"""Columns of text, and whether they hold several."""
BODY = """{mark}
# Questions about {homes} furnished homes

{many} questions of {kinds} kinds about {pictures} pictures{films}, by {by}. Homes, pictures, questions and answers are
computed; nobody was asked and no model wrote any of it.

    from datasets import load_dataset
    questions = load_dataset("FOLDER", split="train")  # the one with this page, which tells the columns' types

| column | holds |
|---|---|
| `messages` | the user's, with an `<image>` or `<video>` for each that is shown; the assistant's, a letter |
| `images` `videos` | paths from this folder |
| `marks` | number, column and row of each number in the first picture |
| `kind` `text` `options` `answer` `value` | the same apart: the letter, and what it stands for |
| `difficulty` | easy, medium or hard, by how many pictures and steps it takes |
| `evidence` | ids of what the answer is worked out from, measured numbers, seconds of a film |
| `id` | of the question within its file, which is a home's |

Answers are of the home's own geometry and of what its pictures show pixel by pixel. What could be understood in two
ways is not asked; wrong answers are mostly the right ones of other questions, so that words alone tell little. `chance`
is what drawing an option gives.

| kind | asks | questions | chance | easy, medium, hard |
|---|---|---|---|---|
{rows}

By letter: {letters}.

Homes are made by rules and a model trained on such, not scanned; their things are plain, their light is clear. All
questions of a file are about one home: to hold questions out, hold whole files out. Pictures have labels beside them
(depth, normals, instances, classes; `views.json` in each folder), which are not to be shown to what is tested. Things
of asset libraries that were indexed keep their own licences; the embedded furniture is under the MIT licence.
"""


def text(files: Mapping[str, Sequence[Row]], by: str) -> str:
    """The page about files of questions, by their names."""
    rows = [row for questions in files.values() for row in questions]
    pictures = {path for row in rows for path in row["images"]}
    films = {path for row in rows for path in row["videos"]}
    kinds = sorted({str(row["kind"]) for row in rows})
    letters = Counter(str(row["answer"]) for row in rows)
    size = next((name for most, name in SIZES if len(rows) < most), LARGEST)
    columns = "\n".join(_column(name, several, "string", "  ") for name, several in COLUMNS.items())
    return HEAD.format(size=size, columns=columns, evidence=_evidence(rows)) + BODY.format(
        mark=MARK, homes=len(files), many=len(rows), kinds=len(kinds), pictures=len(pictures), by=by,
        films=f" and {len(films)} films" if films else "", rows="\n".join(_row(kind, rows) for kind in kinds),
        letters=", ".join(f"{letter} {letters[letter]}" for letter in sorted(letters)))


def _column(name: str, several: bool, type_: str, indent: str) -> str:
    """A column's lines of the head; a bare `on` would be read as yes."""
    return f'{indent}- name: "{name}"\n{indent}  {"sequence" if several else "dtype"}: {type_}'


def _evidence(rows: Sequence[Row]) -> str:
    """The parts of evidence and their types, of all kinds: files alone do not tell those of what they lack."""
    found: dict[str, Any] = {}
    for row in rows:
        for name, value in row["evidence"].items():
            found[name] = found.get(name) or value
    parts = []
    for name, value in sorted(found.items()):
        several = isinstance(value, list)
        first = (value[0] if value else "") if several else value
        parts.append(_column(name, several, "string" if isinstance(first, str) else "float64", "    "))
    return "\n".join(parts)


def _row(kind: str, rows: Sequence[Row]) -> str:
    """A kind's line of the table."""
    asked = [row for row in rows if row["kind"] == kind]
    chance = sum(1 / len(row["options"]) for row in asked) / len(asked)
    hard = Counter(str(row["difficulty"]) for row in asked)
    asks = registry.members("apartgen.stages.qa.kinds").get(kind, "").rstrip(".")
    levels = ", ".join(str(hard[level]) for level in ("easy", "medium", "hard"))
    return f"| `{kind}` | {asks[:1].lower()}{asks[1:]} | {len(asked)} | {chance:.2f} | {levels} |"
