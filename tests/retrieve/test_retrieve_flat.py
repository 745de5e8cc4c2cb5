"""A flat furnished from two real sets of owned models: retrieved, exported, loaded, credited."""

import json
import shutil
import struct
from pathlib import Path

import numpy as np
import pytest

from apartgen.schemas.layout import Layout
from apartgen.stages import export
from apartgen.stages.retrieve import RetrieveConfig, build, open_libraries, run
from apartgen.stages.retrieve.matching.indexed import IndexedLibrary
from apartgen.stages.things.categories import TABLE

SHARED = Path(__file__).parents[3] / "shared" / "data"
HERE = (SHARED / "kenney").exists() and (SHARED / "furniture_sim").exists()
pytestmark = [pytest.mark.slow, pytest.mark.skipif(not HERE, reason="the sets are not here")]
TOYS = ("bedDouble", "cabinetBedDrawer", "bookcaseClosedDoors", "loungeSofa", "tableCoffee", "washer", "chairCushion")
SIMS = ("dishwasher", "microwave", "studyTable", "hingecabinet")


@pytest.fixture(scope="module")
def libraries(tmp_path_factory) -> list[IndexedLibrary]:
    """Some models of both sets, indexed."""
    root = tmp_path_factory.mktemp("sets")
    toys, sims = root / "kenney", root / "furniture_sim"
    toys.mkdir()
    for name in (*(f"{toy}.glb" for toy in TOYS), "License.txt", "movable_nodes.json"):
        shutil.copy(SHARED / "kenney" / name, toys)
    for name in SIMS:
        shutil.copytree(SHARED / "furniture_sim" / name, sims / name)
        for file in (SHARED / "furniture_sim").glob(f"{name}*.xml"):
            shutil.copy(file, sims)
    shutil.copytree(SHARED / "furniture_sim" / "common", sims / "common")
    shutil.copy(SHARED / "furniture_sim" / "LICENSE", sims)
    assert build(toys, "folder", root / "toys", scale=2.0).broken == []
    build(sims, "simobjects", root / "sims")
    return [IndexedLibrary(root / name) for name in ("toys", "sims")]


@pytest.fixture(scope="module")
def home(libraries):
    """One large room with a box for every furniture of the sets, a little off its size."""
    rooms = [{"id": "living_room_1", "type": "living_room", "polygon": [[0, 0], [14, 0], [14, 10], [0, 10]]}]
    door = {"id": "d", "kind": "entrance", "rooms": ["living_room_1"], "segment": [[6, 0], [6.9, 0]], "sill": 0,
            "head": 2}  # fmt: skip
    entries = [entry for library in libraries for entry in library.entries
               if entry.category in TABLE and TABLE[entry.category].place == "floor"]  # fmt: skip
    rng = np.random.default_rng(0)
    objects = []
    for i, entry in enumerate(entries):
        size = (np.array(entry.size) * rng.uniform(0.92, 1.08, 3)).round(3).tolist()
        objects.append({"id": f"o{i}", "room": "living_room_1", "category": entry.category, "yaw": 0.0, "size": size,
                        "center": [2.0 + 3.0 * (i % 4), 2.0 + 2.5 * (i // 4), size[2] / 2]})  # fmt: skip
    layout = Layout(program={"rooms": rooms}, rooms=rooms, openings=[door], objects=objects)
    config = RetrieveConfig(libraries=[str(library.folder) for library in libraries])
    return run(layout, config, rng, open_libraries(config)), open_libraries(config)


def test_what_is_owned_is_used_from_both_sets_and_opens(home):
    furnished, _ = home
    used = [o.asset.library for o in furnished.objects]
    assert len(used) >= 8 and used.count("parametric") == 0 and set(used) == {"kenney", "furniture_sim"}
    assert sum(bool(o.joints) for o in furnished.objects) >= 5


def test_it_exports_loads_and_keeps_its_credits(home, tmp_path):
    mujoco, pxr = pytest.importorskip("mujoco"), pytest.importorskip("pxr")
    furnished, opened = home
    found = export.run(furnished, ["glb", "mjcf", "usd"], tmp_path / "scene", opened.load_asset)
    joints = sum(len(o.joints) for o in furnished.objects)
    assert any("Kenney" in c and "CC0" in c for c in found.credits) and any("Apache-2.0" in c for c in found.credits)
    told = (tmp_path / "scene" / "CREDITS.txt").read_text()
    assert "Kenney" in told and "Apache-2.0" in told

    data = next((tmp_path / "scene").glob("*.glb")).read_bytes()
    about = json.loads(data[20 : 20 + struct.unpack_from("<I", data, 12)[0]])
    assert "Kenney" in about["asset"]["copyright"] and "Apache-2.0" in about["asset"]["copyright"]
    colours = {m["name"]: m["pbrMetallicRoughness"]["baseColorFactor"] for m in about["materials"]}
    # As the set's own file has it, in linear light.
    assert np.allclose(colours["carpet"], (0.9433962, 0.367175967, 0.3426486, 1), atol=1e-3)

    model = mujoco.MjModel.from_xml_path(str(next((tmp_path / "scene" / "mjcf").glob("*.xml"))))
    state = mujoco.MjData(model)
    for _ in range(50):
        mujoco.mj_step(model, state)
    assert model.njnt >= joints and np.isfinite(state.qpos).all() and np.abs(state.qvel).max() < 20

    stage = pxr.Usd.Stage.Open(str(next((tmp_path / "scene" / "usd").glob("*.usd*"))))
    prims = [prim.GetTypeName() for prim in stage.Traverse()]
    moving = prims.count("PhysicsRevoluteJoint") + prims.count("PhysicsPrismaticJoint")
    assert moving >= joints and "Kenney" in stage.GetDefaultPrim().GetAssetInfoByKey("credits")
