"""What the documents quote from the program is what the program says.

`make docs` writes the quotations anew.
"""

import os
import re
from pathlib import Path

import codemap
import commandline
import networkx
import pytest

from apartgen_cli.main import WORDS

ROOT = Path(__file__).parent.parent
DOCUMENTS = ("README.md", "docs/commands.md")
GROUPS = {"dataset": ("build", "verify", "stats", "split", "merge", "export", "rebuild"),
          "train": ("corpus", "layout", "shape"), "assets": ("index", "check", "list", "show", "preview")}
QUOTE = re.compile(r"(<!-- help: (?P<line>[^>]*?) -->\n```text\n)(?P<text>.*?)(```\n)", re.DOTALL)
MAP = re.compile(r"(<!-- map -->\n```mermaid\n)(.*?)(```\n)", re.DOTALL)


@pytest.fixture
def help_of(capsys, monkeypatch):
    monkeypatch.setenv("COLUMNS", "100")

    def text(line: str) -> str:
        done = commandline.run(capsys, monkeypatch, *line.split()[1:], "--help")
        assert done.code == 0, done.err
        return "\n".join(row.rstrip() for row in done.out.strip("\n").splitlines()) + "\n"

    return text


@pytest.mark.parametrize("name", DOCUMENTS)
def test_quoted_help_is_what_the_program_says(help_of, name):
    document = ROOT / name
    text = document.read_text(encoding="utf-8")
    anew = QUOTE.sub(lambda match: match[1] + help_of(match["line"]) + match[4], text)
    if os.environ.get("APARTGEN_WRITE_DOCS"):
        document.write_text(anew, encoding="utf-8")
    assert text == anew, f"{name} quotes another version; run `make docs`"


def test_the_map_of_the_code_is_of_this_code():
    document = ROOT / "docs/architecture.md"
    text = document.read_text(encoding="utf-8")
    anew = MAP.sub(lambda match: match[1] + codemap.flowchart() + match[3], text)
    if os.environ.get("APARTGEN_WRITE_DOCS"):
        document.write_text(anew, encoding="utf-8")
    assert text == anew, "docs/architecture.md draws another version; run `make docs`"


def test_rooms_of_the_code_are_in_floors():
    assert networkx.is_directed_acyclic_graph(codemap.rooms())


def test_every_command_is_quoted():
    quoted = {match["line"] for match in QUOTE.finditer((ROOT / "docs/commands.md").read_text(encoding="utf-8"))}
    wanted = {"apartgen", *(f"apartgen {word}" for word in WORDS)}
    wanted |= {f"apartgen {word} {part}" for word in WORDS for part in GROUPS.get(word, ())}
    assert quoted == wanted


def test_links_lead_somewhere():
    for name in DOCUMENTS:
        document = ROOT / name
        for target in re.findall(r"\]\(([^)#]+)", document.read_text(encoding="utf-8")):
            assert "://" in target or (document.parent / target).exists(), f"{name} links to {target}"
