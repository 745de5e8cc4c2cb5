"""Every file that is installed is told of in NOTICE, and whoever says in one that it is theirs is named there."""

import re
import subprocess
from fnmatch import fnmatch
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
PARTS = ("apartgen", "apartgen_cli", "schemas", "stages")
HOLDER = re.compile(r"(?:copyright|©|\(c\))[ ©]*(?:\(c\) )?\d{4}(?:[-–]\d{4})?,? +([^\n*<\"]+)", re.IGNORECASE)
LICENCE = re.compile(r"SPDX-License-Identifier: *([\w.+-]+)")
NOTICE = (ROOT / "NOTICE").read_text(encoding="utf-8")


@pytest.fixture(scope="module")
def shipped():
    told = subprocess.run(["git", "ls-files", *PARTS], cwd=ROOT, capture_output=True, text=True)
    if told.returncode:
        pytest.skip("no checkout")
    return [name for name in told.stdout.split() if (ROOT / name).is_file()]


def patterns() -> list[str]:
    """Of the files that NOTICE tells of, line by line."""
    items = re.findall(r"^- (`[^:]*`):", NOTICE.partition("Whose every file")[2], re.MULTILINE)
    return [one for item in items for one in re.findall(r"`([^`]+)`", item)]


def holders(text: str) -> set[str]:
    """Who says of a text that it is theirs."""
    return {found.strip(" .").lower() for found in HOLDER.findall(text)}


def test_every_file_is_in_one_line_of_the_notice(shipped):
    found = {name: [one for one in patterns() if fnmatch(name, one)] for name in shipped}
    assert {name: lines for name, lines in found.items() if len(lines) != 1} == {}


def test_every_line_of_the_notice_is_of_a_file(shipped):
    assert [one for one in patterns() if not any(fnmatch(name, one) for name in shipped)] == []


def test_whoever_says_that_a_file_is_theirs_is_in_the_notice(shipped):
    texts = {name: (ROOT / name).read_text(encoding="utf-8") for name in shipped if not name.endswith(".safetensors")}
    named = {name: holders(text) for name, text in texts.items() if holders(text)}
    assert named.keys() == {"stages/export/_viewer/bundle.js", "stages/export/_viewer/three-license.txt"}
    assert {who for of in named.values() for who in of} <= holders(NOTICE)
    assert {id for text in texts.values() for id in LICENCE.findall(text)} == {"MIT"}


def test_holders_are_found_as_files_name_them():
    text = "/* Copyright 2010-2026 Three.js Authors\n * SPDX */ // (c) 1999 Someone Else\n# Copyright (c) 2020 A. B.\n"
    assert holders(text) == {"three.js authors", "someone else", "a. b"}
