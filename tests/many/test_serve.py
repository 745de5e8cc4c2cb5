"""The warm worker: an answer for every line, the same homes as by the commands, a socket for its owner only."""

import json
import os
import socket
import stat
import subprocess
import sys
import threading
from pathlib import Path

import handmade
import pytest

from apartgen import serving
from apartgen.schemas import artifact
from apartgen.schemas.artifact import Made

EXAMPLE = Path(__file__).parents[2] / "examples" / "two-bedroom-flat" / "walkable.json"


def asked(**request) -> dict:
    return serving.answer(json.dumps(request).encode())


def test_every_line_has_an_answer_whatever_it_is():
    wrong = [b"{", b"[]", b'"plan"', b'{"do": "sing"}', b'{"do": 3}', b'{"do": "plan", "sead": 1}', b"\xff\xfe",
             b'{"do": "plan", "prompt": " "}', b'{"do": "plan", "prompt": "studio", "settings": {"heigth": 3}}',
             b'{"do": "layout"}', b'{"do": "layout", "home": {"apartgen": "plan"}}', b'{"do": "layout", "home": "no"}',
             b'{"do": "make", "prompt": "studio"}', b'{"do": "plan", "prompt": "studio", "seed": ' + b"9" * 5000 + b"}",
             b'{"do": "export", "home": "' + str(EXAMPLE).encode() + b'", "out": "x", "formats": ["papyrus"]}']
    found = [json.loads(text) for text in serving.answers([*wrong, b"\n"])]
    assert len(found) == len(wrong)
    for line, reply in zip(wrong, found):
        assert reply["ok"] is False and reply["status"] == 2 and reply["error"], line


def test_what_goes_wrong_inside_is_told_and_the_next_is_answered(monkeypatch):
    monkeypatch.setitem(serving._DO, "check", lambda request: 1 / 0)
    assert asked(do="check", home=str(EXAMPLE), tag="a") == {
        "tag": "a", "ok": False, "status": 70, "error": "ZeroDivisionError: division by zero; please report it"}
    assert asked(do="metrics", home=str(EXAMPLE), tag=7)["tag"] == 7


def test_homes_are_those_of_the_library():
    import apartgen

    reply = asked(do="plan", prompt="studio", seed=4)
    assert reply["home"]["body"] == json.loads(artifact.finish(*_parts(apartgen.plan("studio", seed=4)))[0])["body"]
    assert asked(do="check", home=str(EXAMPLE))["certified"] is True
    home = json.loads(artifact.finish(handmade.plan(), Made(by="test", seed=0))[0])
    assert asked(do="metrics", home=home)["values"]


def _parts(made):
    return made.body, made.made


def test_files_are_written_where_they_are_asked_for(tmp_path):
    reply = asked(do="export", home=str(EXAMPLE), out=str(tmp_path / "scene"), formats=["svg"])
    assert reply["ok"] and all(Path(file).is_file() for file in reply["files"])


def test_standard_input_is_answered_line_by_line():
    running = subprocess.Popen([sys.executable, "-m", "apartgen_cli", "-q", "serve", "--cold"], stdin=subprocess.PIPE,
                               stdout=subprocess.PIPE, text=True)
    assert running.stdin and running.stdout
    for tag in ("one", "two"):
        running.stdin.write(json.dumps({"do": "check", "home": str(EXAMPLE), "tag": tag}) + "\n")
        running.stdin.flush()
        assert json.loads(running.stdout.readline())["tag"] == tag
    running.stdin.close()
    assert running.wait(60) == 0


@pytest.mark.skipif(not hasattr(socket, "AF_UNIX"), reason="needs sockets in the file system")
def test_a_socket_is_its_owners_and_outlives_who_leaves_in_the_middle(tmp_path):
    place, there = tmp_path / "s", threading.Event()
    (dead := socket.socket(socket.AF_UNIX)).bind(str(place))
    dead.close()  # as a worker leaves it that was killed
    threading.Thread(target=serving.listen, args=(place, there.set), daemon=True).start()
    assert there.wait(10) and stat.S_IMODE(os.stat(place).st_mode) == 0o600
    with socket.socket(socket.AF_UNIX) as gone:
        gone.connect(str(place))
        gone.sendall(b'{"do": "check", "home": "')
    with socket.socket(socket.AF_UNIX) as client:
        client.connect(str(place))
        client.settimeout(30)
        with client.makefile("rwb") as both:
            both.write(json.dumps({"do": "check", "home": str(EXAMPLE)}).encode() + b"\n")
            both.flush()
            assert json.loads(both.readline())["certified"] is True
    with pytest.raises(serving.BadInput, match="in use"):
        serving.listen(place)
