"""Lists of prompts: each draws by itself, has a name of its own, and its own error."""

import json
import os
import string

import commandline
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from apartgen.requests import Request, file_name, listed, named, sentence, slug
from apartgen.schemas.errors import ApartgenError, BadInput


@pytest.fixture
def cli(capsys, monkeypatch):
    return lambda *args, stdin=b"": commandline.run(capsys, monkeypatch, *args, stdin=stdin)


def bodies(text: str) -> list[dict]:
    return [json.loads(line)["body"] for line in text.splitlines()]


WORDS = st.text(string.ascii_letters + " -é!1", min_size=1, max_size=12).filter(str.strip)


@given(st.lists(WORDS, min_size=1, max_size=12), st.lists(WORDS, max_size=6, unique=True))
@settings(max_examples=200, deadline=None)
def test_every_request_has_a_name_of_its_own_that_can_be_a_files(prompts, ids):
    read = [*(Request(text.strip()) for text in prompts), *(Request("flat", id=id) for id in ids)]
    done = [one for one in named(read) if isinstance(one, Request)]
    names = [one.name for one in done]
    assert len({name.lower() for name in names}) == len(names)
    assert all(name and "/" not in name and len(name) <= 100 for name in names)
    assert len({(one.prompt, one.id) for one in done}) == len(done), "two would be drawn alike"


@given(WORDS, st.lists(WORDS, max_size=5))
@settings(max_examples=100, deadline=None)
def test_what_is_tried_again_from_a_list_is_the_same_request(prompt, others):
    text = "\n".join([*others, prompt]).encode()
    for one in [one for one in listed(text, "list") if isinstance(one, Request)]:
        [again] = listed(json.dumps(one.row()).encode(), "list")
        assert (again.name, again.id, again.prompt) == (one.name, one.id, one.prompt)


def test_ids_of_any_length_and_letters_are_names_of_files(tmp_path):
    for id in ("a", "a" * 255, "ä/b\0", "..", "x" * 1000, "CON.", "-o", "字" * 300):
        name = file_name(id)
        assert len(os.fsencode(f".{name}.json.part")) <= 255
        (tmp_path / f"{name}.json").write_text("")
    assert len(list(tmp_path.iterdir())) == 8
    assert file_name("home-1.a") == "home-1.a" and slug("Two-bedroom flat!") == "two-bedroom-flat"


def test_a_bad_line_has_an_error_of_its_own():
    rows = [b'{"prompt": "studio", "id": "a"}', b'{"prompt": ""}', b'{"id": "b"}', b'{"prompt": "loft", "seed": -1}',
            b'{"prompt": "loft", "flour": 1}', b"flat.json", b'{"prompt": "x", "id": "a"}', b'{"prompt": "x"',
            b'{"prompt": "x", "seed": ' + b"9" * 5000 + b"}", b'{"prompt": "x", "id": "' + b"i" * 1001 + b'"}',
            b"studio"]
    found = listed(b"\n".join(rows), "list")
    assert [isinstance(one, ApartgenError) for one in found] == [False, *[True] * 9, False]
    for i, one in enumerate(found, 1):
        assert isinstance(one, Request) or f"list:{i}" in str(one) or "given twice" in str(one)


@pytest.mark.parametrize("text", ["plan.json", "a/b.jsonl", '{"prompt": "x"}', "[1]", "/etc/passwd", " "])
def test_what_is_no_sentence_is_refused(text):
    with pytest.raises(BadInput):
        sentence(text)


def test_sentences_are_read_as_ever():
    for text in ("studio", "a flat with en-suite/bath", "2 bed, 1.5 bath", "a home.json of a flat"):
        assert sentence(text) == text


def test_lines_of_standard_input_are_prompts_and_results_are_lines(cli):
    done = cli("plan", stdin="studio\none-bedroom flat\n\nstudio\n")
    assert done.code == 0, done.err
    first, second, third = bodies(done.out)
    assert [body["prompt"] for body in (first, second, third)] == ["studio", "one-bedroom flat", "studio"]
    assert first["rooms"] != third["rooms"], "equal words are different homes"
    assert first == json.loads(cli("plan", "studio").out)["body"], "a plan is the same alone"


def test_all_of_standard_input_is_one_prompt_when_asked(cli):
    done = cli("plan", "--one", stdin="one-bedroom flat\nwith a study\n")
    assert json.loads(done.out)["body"]["prompt"] == "one-bedroom flat\nwith a study"


def test_a_list_of_requests_with_seeds_ids_and_settings(cli, tmp_path):
    file, out = tmp_path / "prompts.jsonl", tmp_path / "plans"
    rows = [{"id": "a", "prompt": "studio"}, {"id": "b", "prompt": "studio"}, {"id": 7, "prompt": "studio", "seed": 5},
            {"id": "high", "prompt": "studio", "settings": {"plan": {"height": 3.1}}},
            {"id": "cut", "prompt": "a 20 m² flat with four bedrooms of 15 m² each"}, {"id": "none"}]
    file.write_text("\n".join(map(json.dumps, rows)))
    done = cli("plan", "--prompts", file, "-o", f"{out}/", "--failures", tmp_path / "failed.jsonl")
    assert done.code == 2 and sorted(os.listdir(out)) == ["7.json", "a.json", "b.json", "high.json"]
    assert "cut: " in done.err and "prompts.jsonl:6: " in done.err and "2 of 6 could not be done" in done.err
    read = {name: json.loads((out / f"{name}.json").read_text()) for name in ("a", "b", "7", "high")}
    assert read["a"]["body"]["rooms"] != read["b"]["body"]["rooms"] and read["a"]["made"]["id"] == "a"
    assert read["7"]["made"]["seed"] == 5 and read["high"]["body"]["height"] == 3.1
    [failed] = map(json.loads, (tmp_path / "failed.jsonl").read_text().splitlines())
    assert failed["id"] == "cut" and failed["status"] == 1 and "four" in failed["prompt"]


def test_what_is_done_is_left_and_what_failed_is_tried_again(cli, tmp_path):
    file, out, failures = tmp_path / "prompts.txt", tmp_path / "plans", tmp_path / "failed.jsonl"
    file.write_text("studio\na 20 m² flat with four bedrooms of 15 m² each\n")
    assert cli("plan", "--prompts", file, "-o", f"{out}/", "--failures", failures).code == 1
    before = (out / "studio.json").stat().st_mtime_ns
    assert "kept" in cli("plan", "--prompts", file, "-o", f"{out}/").err
    assert (out / "studio.json").stat().st_mtime_ns == before
    assert cli("plan", "--prompts", file, "-o", f"{out}/", "--height", 3).code == 1
    assert (out / "studio.json").stat().st_mtime_ns != before, "other settings make it anew"
    failures.write_text(failures.read_text().replace("15 m²", "5 m²").replace("20 m²", "80 m²"))
    assert cli("plan", "--retry", failures, "-o", f"{out}/").code == 0 and failures.read_text() == ""
    assert len(os.listdir(out)) == 2
