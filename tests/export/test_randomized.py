"""Masses, friction and mechanisms drawn by seed: within the tables' ranges, in every file that holds them."""

import json
import tomllib
from collections import defaultdict
from pathlib import Path
from xml.etree import ElementTree

import commandline
import numpy as np
import pytest
from export import sample

from apartgen.schemas import artifact
from apartgen.schemas.walkable import Walkable
from apartgen.stages import export, things
from apartgen.stages.export._randomized import randomized
from apartgen.stages.scene.scene import Scene
from apartgen.stages.things import mechanisms

EXAMPLE = Path(__file__).parents[2] / "examples" / "two-bedroom-flat" / "walkable.json"
FOLDER = Path(things.__file__).parent
SEEDS = range(12)


def _rows(name):
    return tomllib.loads((FOLDER / name).read_text(encoding="utf-8"))


@pytest.fixture(scope="module")
def usual(library):
    return Scene(artifact.read(EXAMPLE, Walkable).body, library, shown=False)


@pytest.fixture(scope="module")
def draws(usual):
    """The flat's bodies by seed."""
    return [randomized(usual, seed) for seed in SEEDS]


def test_furniture_weighs_what_its_kind_may_and_is_near_what_it_weighed(usual, draws):
    rows = _rows("categories.toml")
    shares = []
    for bodies in draws:
        for before, body in zip(usual.bodies, bodies, strict=True):
            if body.kind == "object":
                least, most = rows[body.category]["mass"]
                now, was = (sum(link.mass for link in b.links) for b in (body, before))
                assert least - 1e-9 <= now <= most + 1e-9 and abs(now / was - 1) <= 0.3 + 1e-9, body.name
                assert np.allclose([b.mass / a.mass for a, b in zip(before.links, body.links)], now / was)
                shares.append(now / was)
    assert np.ptp(shares) > 0.5 and abs(np.mean(shares) - 1) < 0.03


def test_surfaces_and_mechanisms_stay_in_the_ranges_of_the_table_and_fill_them(usual, draws):
    table, seen = _rows("mechanisms.toml"), defaultdict(list)
    least, most = table["surface"]["friction"]
    for bodies in draws:
        for before, body in zip(usual.bodies, bodies, strict=True):
            rubs = [now.friction / was.friction for was, now in zip(before.links, body.links)]
            assert np.ptp(rubs) < 1e-9 and least <= rubs[0] <= most
            for link in body.links[1:]:
                kind, own = mechanisms.kind(body.category, link.joint), body.motion(link)
                row = table["mechanisms"][kind]
                assert row["damping"][0] <= own.damping <= row["damping"][1]
                assert 0 < own.friction <= row["friction"][1]
                lever = mechanisms.lever(link)
                for held, name in ((own.catch, "catch"), (own.rest, "rest")):
                    low, high = row.get(name, (0, 0))
                    assert low - 1e-9 <= held / lever <= high + 1e-9
                seen[kind].append((own.damping - row["damping"][0]) / np.ptp(row["damping"]))
            seen["surface"].append((rubs[0] - least) / (most - least))
    assert {"room_door", "drawer", "surface"} <= set(seen)
    assert all(np.ptp(places) > 0.8 for places in seen.values() if len(places) > 60)


def test_one_seed_draws_the_same_another_draws_another_and_a_thing_draws_for_itself(usual, draws):
    def masses(bodies):
        return {body.name: [link.mass for link in body.links] for body in bodies}

    again = randomized(usual, 0)
    assert masses(again) == masses(draws[0]) != masses(draws[1])
    fewer = usual.home.model_copy(update={"objects": usual.home.objects[::2]})
    rest = masses(randomized(Scene(fewer, usual.load_asset, shown=False), 0))
    assert len(rest) < len(again) and rest == {name: masses(again)[name] for name in rest}


def test_files_hold_what_was_drawn_and_nothing_is_drawn_unasked(tmp_path):
    import mujoco

    plain, one, two = (tmp_path / name for name in ("plain", "one", "two"))
    export.run(sample.home(), ["mjcf", "urdf", "sdf"], plain, sample.load)
    made = [export.run(sample.home(), ["mjcf", "urdf", "sdf"], out, sample.load, randomize=4) for out in (one, two)]
    assert made[0] == made[1] and not (plain / "physics.json").exists()
    drawn = json.loads((one / "physics.json").read_text())
    assert drawn["seed"] == 4 and "physics.json" in (one / "SHA256SUMS").read_text()
    model = mujoco.MjModel.from_xml_path(str(one / "mjcf" / "apartment.xml"))
    urdf = ElementTree.parse(one / "urdf" / "apartment.urdf")
    sdf = ElementTree.parse(one / "sdf" / "apartment.sdf")
    joints = 0
    for name, links in drawn["bodies"].items():
        for link, facts in links.items():
            weighs = float(urdf.find(f".//link[@name='{link}']/inertial/mass").get("value"))
            assert weighs == pytest.approx(max(facts["mass"], 0.01))
            assert float(sdf.find(f".//link[@name='{link}']/inertial/mass").text) == pytest.approx(weighs)
            if "joint" in facts:
                joints += 1
                dof = model.jnt_dofadr[model.body(link).jntadr[0]]
                assert model.body(link).mass[0] == pytest.approx(weighs)
                assert model.dof_damping[dof] == pytest.approx(facts["joint"]["damping"])
                assert model.dof_frictionloss[dof] == pytest.approx(facts["joint"]["friction"])
        geoms = [g for g in range(model.ngeom) if model.geom(g).name.startswith(f"{name}__c")]
        assert all(model.geom_friction[g, 0] == pytest.approx(links[name]["friction"]) for g in geoms)
    assert joints > 8
    assert (plain / "mjcf" / "apartment.xml").read_bytes() != (one / "mjcf" / "apartment.xml").read_bytes()


def test_usd_holds_what_was_drawn(tmp_path):
    usd = pytest.importorskip("pxr.Usd")
    from pxr import UsdPhysics

    export.run(sample.home(), ["usd"], tmp_path / "scene", sample.load, randomize=1)
    stage = usd.Stage.Open(str(tmp_path / "scene" / "usd" / "apartment.usd"))
    drawn = json.loads((tmp_path / "scene" / "physics.json").read_text())["bodies"]
    known = {prim.GetCustomDataByKey("apartgen")["id"]: prim for prim in stage.Traverse()
             if (prim.GetCustomDataByKey("apartgen") or {}).get("id")}
    parts = 0
    for name, links in drawn.items():
        weighed = [UsdPhysics.MassAPI(prim).GetMassAttr().Get() for prim in usd.PrimRange(known[name])
                   if prim.HasAPI(UsdPhysics.MassAPI)] if name in known else []
        if weighed:
            parts += len(weighed)
            assert sorted(weighed) == pytest.approx(sorted(facts["mass"] for facts in links.values()), rel=1e-5)
    assert parts > 15


def test_the_command_draws_by_the_seed_given_or_the_homes_own(tmp_path, capsys, monkeypatch):
    def drawn(*words):
        out = tmp_path / "-".join(["to", *words])
        done = commandline.run(capsys, monkeypatch, "export", EXAMPLE, "--format", "svg", *words, "-o", out)
        assert done.code == 0, done.err
        return json.loads((out / "physics.json").read_text()) if (out / "physics.json").exists() else None

    assert drawn() is None
    own, other = drawn("--randomize"), drawn("--randomize", "--seed", "77")
    assert own["seed"] == artifact.read(EXAMPLE, Walkable).made.seed and other["seed"] == 77
    assert own["bodies"] != other["bodies"]
