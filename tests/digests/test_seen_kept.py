"""What other cameras see of other homes, films but for their encoding, and what is asked of them, as it was."""

import numpy as np
import pytest
from digests import kept

from apartgen.schemas.render import Film, Shown
from apartgen.stages import qa, render, seeds
from apartgen.stages.qa import card, drafts, films
from apartgen.stages.qa.config import QaConfig
from apartgen.stages.qa.facts import Facts
from apartgen.stages.render import coco, film, labels, photo, points, route, stands
from apartgen.stages.render.config import RenderConfig
from apartgen.stages.scene.scene import Scene
from apartgen.stages.scene.world import world

pytestmark = pytest.mark.wide

CAMERAS = {
    "flat": RenderConfig(width=160, height=90, views=6, frames=3, points=150, field=65.0, eye=1.7, robot=0.6),
    "house": RenderConfig(width=96, height=128, views=5, frames=4, points=0, field=100.0, kind=["eye", "route"]),
}


@pytest.fixture(scope="module")
def seen(tmp_path_factory):
    """Homes with what was rendered of them, by name."""
    found = {}

    def of(name):
        if name not in found:
            out = tmp_path_factory.mktemp("seen") / name
            found[name] = out, render.run(kept.home(name), CAMERAS[name], seeds.drawn(2, name), out, kept.load)
        return found[name]
    return of


@pytest.mark.parametrize("name", CAMERAS)
def test_pictures(seen, name):
    out, found = seen(name)
    kept.same("render", f"seen {name}", {file.path: out / file.path for file in found.files} | {
        "list": found.views, "things": found.instances, "labels": found.labels})


@pytest.mark.parametrize("name", CAMERAS)
def test_questions(seen, name, tmp_path):
    _, views = seen(name)
    told = {}
    for seed in range(3):
        found = qa.run(kept.home(name), views, QaConfig(each=3 + 4 * seed), kept.lane("qa", str(seed)))
        told |= {f"{kind} {seed}": [one for one in found if one.kind == kind] for kind in qa.every_kind()}
    lines = qa.lines(found, "views")
    facts = Facts(kept.home(name), views)
    told |= {"lines": lines, "card": card.text({"a": [one.model_dump() for one in found]}, "apartgen"),
             "names": facts.names, "room names": facts.room_names, "marked": facts.marked,
             "apart": [facts.apart(a, b) for a in list(facts.names)[:12] for b in list(facts.names)[:12]],
             "ways": [[a.id, b.id, facts.way(a.id, b.id)] for a in facts.home.rooms for b in facts.home.rooms]}
    kept.same("qa", f"asked {name}", told)


@pytest.mark.parametrize("name", kept.HOMES)
def test_ways_of_cameras(name):
    """Where pictures and films would be taken from, and what frames of a film would show."""
    home = kept.home(name)
    scene = Scene(home, kept.load)
    shown = world(scene)
    config = RenderConfig(width=48, height=36, rate=2, speed=1.5, video=True)
    some = film.moments(shown, config)
    cameras = film.lenses(some, config, -0.2)
    looks = list(film.looks(scene, shown, some[::9], cameras[::9])) if name == "studio" else []
    kept.same("render", f"ways {name}", {
        "best": stands.best(shown, 6, 1.6, 1.2, (40, 30)), "middles": stands.middles(shown, 1.2),
        "moments": some, "lenses": [[one.eye, one.frame, one.half, one.middle] for one in cameras[::9]],
        "back": film.moments(shown, config.model_copy(update={"back": True, "speed": 4.0})),
        "along": route.along(shown, 7, 0.9, back=True), "length": route.length(shown), "doors": film.doors(shown),
        "looks": looks, "evened": film.evened([look.meter for look in looks], 2) if looks else None,
        "written": points.written(home), "uneven": photo.uneven(shown.bodies), "panes": len(shown.panes),
        "classes": labels.classes(shown.bodies), "things": labels.instances(shown)})


def test_masks():
    rng, found = np.random.default_rng(3), []
    for k in range(40):
        numbers = rng.integers(0, 4, (rng.integers(1, 9), rng.integers(1, 9))).repeat(1 + k % 5, 0).repeat(1 + k % 7, 1)
        found.append([[coco.runs(numbers == n), coco.compressed(numbers == n)] for n in range(4)])
        found[-1].append(labels.visible(numbers.astype(np.uint16)))
    kept.same("render", "masks", {"found": found})


def test_drafts():
    """Of questions that nobody asks: which of them go together, and what becomes of their letters."""
    found = {}
    for seed in range(30):
        rng = np.random.default_rng(seed)
        names = [f"thing {k}" for k in range(rng.integers(3, 9))]
        some = []
        for k in range(int(rng.integers(2, 30))):
            a, b, *barred = rng.choice(names, 3, replace=False).tolist()
            value = float(rng.uniform(0.1, 6)) if seed % 3 == 0 else None
            answer, views = a if value is None else f"{value:.1f}", [f"view {j}" for j in range(1 + k % 5)]
            some.append(drafts.Draft(f"text {k % 9}", answer, views, {}, (b,), value, int(rng.integers(3)),
                                     frozenset(barred) if k % 4 == 0 else frozenset()))
        found[str(seed)] = {name: drafts.asked("kind", chosen, rng) for name, chosen in (
            ("shared", drafts.shared(some, rng, 12)), ("two", drafts.shared(some, rng, 6)),
            ("balanced", drafts.balanced(some, rng, 9)), ("either", drafts.either_way(some, rng, 7)),
            ("some", drafts.some(some, rng, 8)))}
    kept.same("qa", "drafts", found)


def test_sights(seen):
    """Of films that were never taken: what comes into sight when."""
    _, views = seen("flat")
    facts, found = Facts(kept.home("flat"), views), {}
    numbers = [thing.number for thing in views.instances if thing.id in facts.names]
    for seed in range(12):
        rng, frames, pixels = np.random.default_rng(seed), [], {n: 0.0 for n in numbers[:10]}
        for k in range(60):
            for n in pixels:
                pixels[n] = max(0.0, pixels[n] + rng.normal(0, 60))
            some = [(n, int(p)) for n, p in pixels.items() if p > 0]
            frames.append(Shown(seconds=k / 5, room=f"room {k // (9 + seed) % 3}", visible=some))
        shown = Film(file="walk.mp4", rate=5, width=160, height=90, frames=frames)
        sights = films.sights(facts, shown)
        rows = list(sights.values())
        found[str(seed)] = [sights, films.stays(shown), [films.in_order([a, b]) for a in rows for b in rows]]
    kept.same("qa", "sights", found)
