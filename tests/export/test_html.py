"""The page: whole in one file, and in a browser its parts open at a click and its rooms stand alone."""

import base64
import json
import os
import re
import shutil

import numpy as np
import pytest
from export import sample

from apartgen.stages import export
from apartgen.stages.export.html import VIEWER

BROWSERS = ("chromium", "google-chrome", "chrome", "chromium-headless-shell")
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


def test_the_bundle_is_of_these_sources():
    """Every longer word and sentence that the sources show is in the bundle."""
    bundle = (VIEWER / "bundle.js").read_text(encoding="utf-8")
    for file in (VIEWER / "src").glob("*.js"):
        text = re.sub(r"^import.*?;$", "", file.read_text(encoding="utf-8"), flags=re.M | re.S)
        words = re.findall(r'"(\w[\w ,.:#]{5,})"', text)
        assert words or file.name == "walk.js"
        assert not [word for word in words if word not in bundle], f"{file.name}: npm run build"


def test_two_homes_share_a_page_and_a_program(tmp_path):
    from apartgen.stages.export import html
    from apartgen.stages.scene.scene import Scene

    scenes = [Scene(sample.home().model_copy(update={"prompt": prompt}), sample.load) for prompt in ("a</script>", "b")]
    text = html.pair(scenes, [["objects < 9", "1", "2"]])
    assert len(text) < 2.2 * len(html.page(scenes[0])) - len((VIEWER / "bundle.js").read_bytes()) / 2
    pages = json.loads(re.search(r'<script id="pages"[^>]*>(.*?)</script>', text, re.S)[1])
    assert [page["title"] for page in pages] == ["a</script>", "b"]
    assert all(page["page"].count(html.MARK) == 1 for page in pages)
    assert '<th scope="row">objects &lt; 9</th><td>1</td><td>2</td>' in text
    program = re.search(r'<script id="program"[^>]*>(.*?)</script>', text, re.S)[1]
    assert base64.b64decode(program) == (VIEWER / "bundle.js").read_bytes()


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
    tab.set_default_timeout(60_000)
    said = []
    tab.on("pageerror", lambda error: said.append(str(error)))
    tab.on("console", lambda message: said.append(message.text))
    tab.goto(page.as_uri(), wait_until="commit")
    tab.wait_for_selector("body[data-ready]")
    tab.evaluate("document.querySelectorAll('details').forEach((part) => (part.open = true))")
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


@pytest.mark.parametrize("quarter, side", [(0, (1, 0)), (1, (0, -1)), (2, (-1, 0)), (3, (0, 1))])
def test_a_home_is_first_seen_from_where_its_fronts_look_to(quarter, side, browser, tmp_path):
    """Shelves that look north are seen from the north, and so on."""
    home = sample.home()
    shelf = next(o for o in home.objects if o.category == "tv_stand")
    home = home.model_copy(update={"objects": [shelf.model_copy(update={"yaw": quarter * np.pi / 2})]})
    export.run(home, ["html"], tmp_path / "x", sample.load)
    tab = browser.new_page(viewport={"width": 640, "height": 420})
    tab.goto((tmp_path / "x" / "apartment.html").as_uri(), wait_until="commit")
    tab.wait_for_selector("body[data-ready]", timeout=60_000)
    way = "((a, b) => [a.x - b.x, a.z - b.z])(apartment.view.camera.position, apartment.view.controls.target)"
    where = np.array(tab.evaluate(way))
    tab.close()
    assert where @ side > 1 and abs(where @ side) > 4 * abs(where @ side[::-1])


def test_walls_are_cut_where_they_hide(shown):
    """A ray to a floor behind a wall's upper part meets the floor, and the wall again once ceilings are shown."""
    name = """(() => {
        const { view } = apartment, floor = apartment.bodies.find((body) => body.name === "floor_bedroom_1");
        const box = floor.userData.box, point = view.camera.position.clone();
        const met = [];
        for (let i = 1; i < 8; i++) for (let j = 1; j < 8; j++) {
            point.set(box.min.x + (box.max.x - box.min.x) * i / 8, 0.01, box.min.z + (box.max.z - box.min.z) * j / 8);
            point.project(view.camera);
            let hit = view.hit((point.x + 1) / 2 * innerWidth, (1 - point.y) / 2 * innerHeight)?.object;
            while (hit && !hit.userData.kind) hit = hit.parent;
            met.push(hit ? hit.userData.kind : "");
        }
        return met;
    })()"""
    shown.evaluate("(() => { const { view } = apartment; view.camera.position.y *= 0.45; view.controls.update(); })()")
    cut = shown.evaluate(name)
    shown.evaluate("(() => { apartment.view.cut.on = false; })()")
    whole = shown.evaluate(name)
    hides = [kind in ("wall", "lining", "trim", "window", "door") for kind in whole]
    assert sum(hides) > 5
    assert not [a for a, hidden in zip(cut, hides) if hidden and a in ("wall", "lining", "trim", "window")]


def test_sliders_move_parts_and_the_address_keeps_them(shown):
    shown.evaluate("apartment.view.pick(apartment.bodies.find((body) => body.name === 'toilet_15'))")
    assert "toilet" in shown.inner_text("#name") and "wall" in shown.inner_text("#why")
    shown.evaluate("""(() => { const slider = document.querySelector("#joints input");
        slider.value = 0.5; slider.dispatchEvent(new Event("input")); })()""")
    assert _turned(shown, "toilet_15__lid") == pytest.approx(np.pi / 6, abs=1e-3)
    shown.wait_for_function("location.hash.includes('toilet_15__lid')")
    shown.evaluate("apartment.view.layer('boxes', true)")
    shown.wait_for_function("location.hash.includes('boxes')")
    shown.reload(wait_until="commit")
    shown.wait_for_selector("body[data-ready]")
    assert _turned(shown, "toilet_15__lid") == pytest.approx(np.pi / 6, abs=1e-2)
    assert shown.is_checked("#layer_boxes") and "toilet" in shown.text_content("#name")


def test_one_walks_until_something_is_in_the_way(shown):
    shown.click("#walk")
    cells = """(() => { const { x, y, cell, runs } = apartment.view.home.facts.free;
        const p = apartment.view.camera.position, r = Math.floor((-p.z - y) / cell), c = Math.floor((p.x - x) / cell);
        return runs.some(([row, from, to]) => row === r && c >= from && c < to); })()"""
    before = shown.evaluate("apartment.view.camera.position.toArray()")
    for _ in range(60):  # 30 s of walking straight on
        shown.evaluate("(() => { const { walk } = apartment.view; walk.press('KeyW', true); walk.advance(0.5); })()")
        assert shown.evaluate(cells)
    after = shown.evaluate("apartment.view.camera.position.toArray()")
    assert 0.5 < float(np.hypot(after[0] - before[0], after[2] - before[2])) < 12
    shown.keyboard.press("Escape")
    assert not shown.evaluate("apartment.view.walk.on")
