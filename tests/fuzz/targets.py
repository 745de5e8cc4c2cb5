"""What is fuzzed: every reader, and the stages behind them. A target makes one case of a random number generator.

A case is passed when the target returns, or raises an ApartgenError, in time; anything else is a fault of the program.
"""

import io
import json
import random
import zipfile
from collections.abc import Callable
from functools import cache
from pathlib import Path

import handmade
import numpy as np

from apartgen import planning, requests, serving, settings, whole
from apartgen.dataset import shape, statistics, verify
from apartgen.dataset.grammar import Grammar
from apartgen.dataset.store import MANIFEST, Store
from apartgen.schemas import artifact
from apartgen.schemas.base import Record
from apartgen.schemas.errors import ApartgenError
from apartgen.schemas.plan import Plan
from apartgen.stages import check, metrics, seeds
from apartgen.stages.plan import imports
from apartgen.stages.plan.config import PlanConfig
from apartgen.stages.retrieve import folder as models
from apartgen.stages.retrieve import simobjects
from fuzz.spoil import VALUES, spoilt, spoilt_bytes

Target = Callable[[random.Random, Path], object]
GOLDEN = Path(__file__).parent.parent / "golden"
KINDS = ("plan", "layout", "retrieve", "walkable", "populate")
WORDS = ("two-bedroom", "flat", "studio", "with", "a", "desk", "no", "70", "m²", "3", "x", "4", "m", "kitchen", "north",
         "of", "the", "en-suite", "and", "or", "but", "without", ",", ".", "bedrooms", "bath", "1/2", "0", "-5",
         "99999999999", "larger", "than", "not", "four", "people", "½", "—", "küche", "\u202e", "(", ")", "'",
         "corridor", "between")


@cache
def golden(kind: str, version: int = 2) -> dict:
    """A file of this version, as a value."""
    return json.loads((GOLDEN / f"v{version}" / f"{kind}.json").read_text())


@cache
def handmade_home() -> dict:
    """A furnished home of two rooms, small enough to judge many of."""
    home = handmade.home(
        handmade.thing("double_bed", 6.04, 1.5, np.pi, handmade.BEDROOM), handmade.thing("sofa", 2, 2.52, -np.pi / 2),
        handmade.thing("wardrobe", 4.5, 2.6, -np.pi / 2, handmade.BEDROOM), handmade.thing("chair", 1.0, 1.0))
    made = artifact.Made(by="hand", seed=0)
    return json.loads(artifact.finish(home, made)[0])


def artifact_bytes(rng: random.Random, folder: Path) -> None:
    """Files that disks have damaged, of either version."""
    data = json.dumps(golden(rng.choice(KINDS[:3]), rng.choice((1, 2)))).encode()
    artifact.parse(spoilt_bytes(data, rng), "fuzz", Record, whole=True)


def artifact_values(rng: random.Random, folder: Path) -> None:
    """Files of other programs: well formed, with something else where it matters."""
    artifact.parse(json.dumps(spoilt(golden(rng.choice(KINDS[:4])), rng)).encode(), "fuzz", Record, whole=True)


def homes(rng: random.Random, folder: Path) -> None:
    """What is read goes to the judge, the metrics and the shape of data sets."""
    raw = handmade_home()
    raw = raw | {"body": spoilt(raw["body"], rng, rng.choice((1, 2)))}
    home = artifact.parse(json.dumps(raw).encode(), "fuzz", Plan, whole=True).body
    check.run(home)
    metrics.run(home)
    shape.of(home)


def stages(rng: random.Random, folder: Path) -> None:
    """What is read goes through the stages, and is drawn."""
    raw = handmade_home() if rng.random() < 0.5 else golden(rng.choice(KINDS[:4]))
    raw = raw | {"body": spoilt(raw["body"], rng, 1)}
    file = folder / "home.json"
    file.write_text(json.dumps(raw))
    serving.answer(json.dumps({"do": "check", "home": str(file)}).encode())
    for word in ("layout", "retrieve", "walkable", "populate"):
        extra = {"settings": {"candidates": 1}} if word == "layout" else {}
        told = serving.answer(json.dumps({"do": word, "home": str(file), **extra}).encode())
        assert told["ok"] or told["status"] in (1, 2), told
        if told["ok"]:
            file.write_text(json.dumps(told["home"]))
    asked = {"do": "export", "home": str(file), "out": str(folder / "scene"), "formats": ["svg", "glb"]}
    told = serving.answer(json.dumps(asked).encode())
    assert told["ok"] or told["status"] in (1, 2), told


def prompts(rng: random.Random, folder: Path) -> None:
    """Sentences of words in any order."""
    text = " ".join(rng.choice(WORDS) for _ in range(rng.randrange(1, 25)))
    planning.read(planning.checked(text), planning.PlanSettings(), seeds.drawn(0, "fuzz"))


def lists(rng: random.Random, folder: Path) -> None:
    """Lists of prompts."""
    rows = [{"id": "a", "prompt": "studio", "seed": 3, "settings": {"plan": {"height": 3}}}, {"prompt": "flat"}]
    text = "\n".join([json.dumps(spoilt(row, rng)) for row in rows] + ["two-bedroom flat", "studio"])
    requests.listed(spoilt_bytes(text.encode(), rng) if rng.random() < 0.5 else text.encode(), "fuzz")


def served(rng: random.Random, folder: Path) -> None:
    """Requests of a warm worker; nothing of it is to be written anywhere."""
    row = {"do": rng.choice(("check", "metrics", "sing")), "home": golden("plan"), "tag": 1, "seed": 0}
    line = json.dumps(spoilt(row, rng)).encode()
    told = serving.answer(spoilt_bytes(line, rng) if rng.random() < 0.3 else line)
    assert told["ok"] or told["status"] in (1, 2), told


def grammars(rng: random.Random, folder: Path) -> None:
    """Grammars that are no TOML, have no end, or no text."""
    text = b'home = ["{one} {two}", [2, "flat of {40-90/5} m2"]]\none = ["a", "{two}"]\ntwo = ["b", "{home}"]\n'
    (folder / "g.toml").write_bytes(spoilt_bytes(text, rng))
    grammar = Grammar.read(str(folder / "g.toml"))
    for i in range(3):
        grammar.sentence(1, i)


def configurations(rng: random.Random, folder: Path) -> None:
    """Settings of every stage."""
    word = rng.choice(list(whole.KINDS))
    fields = list(whole.KINDS[word].model_fields)
    settings.by_stage({word: {rng.choice([*fields, "no such"]): rng.choice(VALUES)}}, ["svg"])


def datasets(rng: random.Random, folder: Path) -> None:
    """Data sets whose files somebody has changed."""
    store = Store(folder)
    about = {"apartgen_dataset": 1, "by": "x", "seed": 0, "per_shard": 2, "count": 1, "settings": {}, "source": {},
             "stages": ["plan"]}
    row = {"id": "a", "prompt": "studio", "seed": 0, "kind": "plan", "digests": {"plan": "x"}, "certified": True,
           "metrics": {"R_out": 0.0}, "rooms": {"bedroom": 1}, "objects": {}, "signature": "s", "sides": [1.0, 2.0],
           "area": 2.0, "seconds": {"all": 1.0}, "shard": "00000.jsonl.gz", "start": 0, "length": 4, "sha256": "x"}
    (folder / "homes").mkdir(exist_ok=True)
    (folder / "homes" / "00000.jsonl.gz").write_bytes(rng.randbytes(4))
    store.describe(spoilt(about, rng) if rng.random() < 0.3 else about)
    lines = "".join(json.dumps(spoilt(row, rng) if rng.random() < 0.7 else row) + "\n" for _ in range(2)).encode()
    (folder / MANIFEST).write_bytes(spoilt_bytes(lines, rng) if rng.random() < 0.3 else lines)
    for _ in verify.verify(store, workers=1):
        pass
    statistics.statistics(store)


def imported(rng: random.Random, folder: Path) -> None:
    """Floor plans of other programs."""
    name, data = rng.choice(list(_foreign().items()))
    if name.endswith(".json") and rng.random() < 0.7:
        data = json.dumps(spoilt(json.loads(data), rng)).encode()
    else:
        data = spoilt_bytes(data, rng)
    if name.endswith(".xml"):
        name, data = "home.sh3d", _zipped(folder, data)
    imports.read(name, data, PlanConfig(candidates=1, enough=1))


def assets(rng: random.Random, folder: Path) -> None:
    """Models of other people."""
    name, data = rng.choice(list(_models().items()))
    file = folder / name
    file.write_bytes(spoilt_bytes(data, rng))
    reader = models if name.endswith((".obj", ".gltf")) else simobjects
    try:
        for source in reader.assets(folder):
            source.load()
    finally:
        file.unlink()


@cache
def _foreign() -> dict[str, bytes]:
    """A plan in every format that text is enough for; one of Sweet Home 3D is packed when it has been spoilt."""
    from plan.imports import writers

    home = artifact.read(GOLDEN / "v2" / "layout.json", artifact.BODIES["layout"]).body
    with zipfile.ZipFile(io.BytesIO(writers.sh3d(home))) as archive:
        xml = archive.read("Home.xml")
    return {"home.xml": xml, "roomplan.json": writers.roomplan(home), "procthor.json": writers.procthor(home)}


def _zipped(folder: Path, data: bytes) -> bytes:
    with zipfile.ZipFile(folder / "x.sh3d", "w") as archive:
        archive.writestr("Home.xml", data)
    return (folder / "x.sh3d").read_bytes()


@cache
def _models() -> dict[str, bytes]:
    """A box in every format of models."""
    corners = [(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]
    faces = [(1, 2, 4, 3), (5, 7, 8, 6), (1, 5, 6, 2), (3, 4, 8, 7), (1, 3, 7, 5), (2, 6, 8, 4)]
    obj = "".join(f"v {x} {y} {z}\n" for x, y, z in corners) + "".join(f"f {a} {b} {c} {d}\n" for a, b, c, d in faces)
    box = '<geometry><box size="1 0.5 0.3"/></geometry>'
    urdf = (f'<robot name="chair"><link name="a"><visual>{box}</visual><collision>{box}</collision></link>'
            f'<link name="b"><visual>{box}</visual></link>'
            '<joint name="door" type="revolute"><parent link="a"/><child link="b"/>'
            '<origin xyz="0 0 1"/><axis xyz="0 0 1"/><limit lower="0" upper="1.5"/></joint></robot>')
    mjcf = ('<mujoco><default><geom rgba="1 0 0 1"/></default><worldbody><body name="chair"><geom type="box" '
            'size=".1 .2 .3"/><body pos="0 0 .5"><joint type="hinge" axis="0 0 1" range="0 1"/><geom type="capsule" '
            'fromto="0 0 0 0 0 1" size=".1"/></body></body></worldbody></mujoco>')
    sdf = f'<sdf version="1.7"><model name="chair"><link name="a"><visual name="v">{box}</visual></link></model></sdf>'
    texts = {"chair.obj": obj, "chair.urdf": urdf, "chair.xml": mjcf, "chair.sdf": sdf}
    return {name: text.encode() for name, text in texts.items()}


SHARE: dict[Target, int] = {
    artifact_bytes: 900, artifact_values: 400, homes: 200, prompts: 200, lists: 1420, served: 500, grammars: 500,
    configurations: 500, datasets: 150, imported: 80, assets: 150}
"""How many of 5 000 cases each target gets; `stages` takes seconds a case and is for long runs."""
SLOW: dict[Target, int] = {stages: 5}


def passes(target: Target, seed: int, folder: Path) -> None:
    """One case, by its number."""
    try:
        target(random.Random(f"{target.__name__} {seed}"), folder)
    except ApartgenError:
        pass
