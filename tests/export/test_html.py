"""The page: whole in one file, and in a browser its parts open at a click and its rooms stand alone."""

import base64
import os
import re
import shutil

import numpy as np
import pytest
from export import sample

from apartgen.stages import export
from apartgen.stages.export.html import VIEWER

BROWSERS = ("chromium", "google-chrome", "chrome")
MOST = 1_500_000
"""Bytes of the viewer without a scene."""


@pytest.fixture(scope="module")
def page(exported):
    return exported("html") / "apartment.html"


def test_the_page_names_nothing_outside_itself(page, exported):
    text = page.read_text(encoding="utf-8")
    frame = text[: text.index('<script id="scene"')]
    assert not re.search(r"""(src|href)\s*=|url\(|@import""", frame)
    assert len((VIEWER / "bundle.js").read_bytes()) < MOST
    held = re.search(r'<script id="scene"[^>]*>([^<]*)</script>', text)[1]
    assert base64.b64decode(held) == (exported("glb") / "apartment.glb").read_bytes()
    assert "The MIT License" in text and "three.js authors" in text


def test_a_prompt_is_text_and_never_markup(tmp_path):
    home = sample.home().model_copy(update={"prompt": "<script>alert(1)</script> & co"})
    export.run(home, ["html"], tmp_path / "x", sample.load)
    text = (tmp_path / "x" / "apartment.html").read_text(encoding="utf-8")
    assert "<title>&lt;script&gt;alert(1)&lt;/script&gt; &amp; co</title>" in text


@pytest.fixture(scope="module")
def browser():
    sync = pytest.importorskip("playwright.sync_api")
    flags = ["--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--no-sandbox"]
    own = next(filter(None, map(shutil.which, BROWSERS)), None)
    with sync.sync_playwright() as started:
        if own is None and not os.path.exists(started.chromium.executable_path):
            pytest.skip("no Chromium is installed")
        opened = started.chromium.launch(executable_path=own, args=flags)
        yield opened
        opened.close()


@pytest.fixture
def shown(page, browser):
    """The page from disk, without a network."""
    context = browser.new_context(viewport={"width": 640, "height": 420}, offline=True)
    tab = context.new_page()
    tab.set_default_timeout(240_000)
    said = []
    tab.on("pageerror", lambda error: said.append(str(error)))
    tab.on("console", lambda message: said.append(message.text) if message.type == "error" else None)
    tab.goto(page.as_uri(), wait_until="commit")
    tab.wait_for_selector("body[data-ready]")
    yield tab
    assert not said
    context.close()


def _turned(tab, name):
    """How far a part is turned from where it was, rad."""
    tab.wait_for_function("apartment.parts.every((part) => part.share === part.goal)")
    w = tab.evaluate(f"""(() => {{
        const part = apartment.parts.find((part) => part.node.name === "{name}");
        return part.turn.angleTo(part.node.quaternion);
    }})()""")
    return float(w)


def test_parts_open_at_a_click_and_rooms_stand_alone(shown):
    lid = "toilet_15__lid"
    shown.evaluate(f"apartment.look('{lid}')")
    shown.mouse.click(*shown.evaluate(f"apartment.at('{lid}')"))
    assert _turned(shown, lid) == pytest.approx(np.pi / 3, abs=1e-3)
    assert _turned(shown, "door_1__leaf") == 0
    shown.click("#open")
    assert _turned(shown, "door_1__leaf") == pytest.approx(np.pi / 2, abs=1e-3)
    shown.click("#shut")
    assert _turned(shown, lid) == pytest.approx(0, abs=1e-3)

    shown.click("#rooms button[value=bedroom_1]")
    seen = set(shown.evaluate("apartment.bodies.filter((body) => body.visible).map((body) => body.name)"))
    assert {"double_bed_9", "floor_bedroom_1", "door_2", "window_2"} <= seen
    assert not {"sofa_1", "walls", "floor_hallway_1", "ceiling_bedroom_1", "window_1", "skirting_hallway_1"} & seen
    shown.keyboard.press("Escape")
    seen = set(shown.evaluate("apartment.bodies.filter((body) => body.visible).map((body) => body.name)"))
    assert {"sofa_1", "walls"} <= seen and "ceiling_bedroom_1" not in seen
