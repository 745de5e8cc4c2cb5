"""What things are like when one comes in: on or off, open or shut, by seed; and that files say so."""

import json
import struct

import mujoco
import numpy as np
import pytest
from inhabited import furnished, library

from apartgen.schemas.populate import furniture_only
from apartgen.stages import export, populate, seeds
from apartgen.stages.things import affordances, categories, small


def lived(seed=0, **settings):
    home = furnished()
    lane = seeds.drawn(seed, "populate", seeds.plan_digest(home))
    return populate.run(home, populate.PopulateConfig(**settings), lane, library())


def test_what_is_switchable_is_on_or_off_and_nothing_else_is():
    home = lived()
    switchable = {id for id, names in home.affordances.items() if "switchable" in names}
    assert {id for id, state in home.states.items() if "on" in state} == switchable
    by = {o.id: o.category for o in home.objects}
    assert {"ceiling_lamp", "tv", "hob", "kitchen_sink", "light_switch"} <= {by[id] for id in switchable}
    assert not {"chair", "double_bed", "mug"} & {by[id] for id in switchable}


def test_uses_say_what_things_afford():
    home = lived()
    by = {o.category: home.affordances.get(o.id, []) for o in home.objects}
    assert "heat_source" in by["hob"] and "water_source" in by["kitchen_sink"] and "sittable" in by["chair"]
    for o in home.objects:
        names = home.affordances.get(o.id, [])
        assert ("openable" in names) == bool(o.joints)
        assert ("graspable" in names) == bool(getattr(o, "grasps", []))
    assert {name for kind in small.TABLE.values() for name in kind.affords} <= {
        name for names in (*affordances.BY_USE.values(), *(k.affords for k in categories.TABLE.values()))
        for name in names}


def test_switches_switch_lamps_of_their_room():
    home = lived()
    objects = {o.id: o for o in home.objects}
    assert home.switches
    for switch, lamps in home.switches.items():
        assert objects[switch].category == "light_switch" and lamps
        assert all(objects[lamp].category.endswith("lamp") and objects[lamp].room == objects[switch].room
                   for lamp in lamps)
        assert home.states[switch]["on"] == any(home.states[lamp]["on"] for lamp in lamps)


def test_parts_are_shut_unless_asked_for_and_the_things_are_the_same():
    shut, ajar = lived(), lived(doors_open=True, parts="random")
    assert [o.model_dump() for o in shut.objects] == [o.model_dump() for o in ajar.objects]
    assert not any(name.startswith("open.") for state in shut.states.values() for name in state)
    doors = {o.id for o in furnished().openings if o.kind == "door" and o.into}
    assert doors and all(ajar.states[id] == {"open.leaf": 1.0} for id in doors)
    drawn = [lived(seed, parts="random") for seed in range(6)]
    joints = {(o.id, f"open.{j.name}") for o in shut.objects for j in o.joints}
    opened = [{(id, name): share for id, state in home.states.items() for name, share in state.items()
               if name.startswith("open.")} for home in drawn]
    assert any(opened) and all(set(found) <= joints for found in opened)
    assert all(0 < share <= 1 for found in opened for share in found.values())
    assert len({tuple(sorted(found)) for found in opened}) > 1
    assert drawn[0].states == lived(0, parts="random").states


def test_a_drawer_with_things_in_it_is_not_drawn_open():
    for seed in range(6):
        home = lived(seed, parts="random", density=2.0)
        full = {o.in_.object for o in home.objects if getattr(o, "in_", None)}
        slides = {(o.id, f"open.{j.name}") for o in home.objects for j in o.joints if j.type == "slide"}
        opened = {(id, name) for id, state in home.states.items() for name in state}
        assert not {(id, name) for id, name in slides & opened if id in full}


def test_without_its_things_a_home_says_nothing_of_them():
    raw = lived().model_dump(mode="json", by_alias=True)
    assert not {"states", "affordances", "switches", "receptacles"} & set(furniture_only(raw))


@pytest.fixture(scope="module")
def exported(tmp_path_factory):
    out = tmp_path_factory.mktemp("states")
    home = lived(3, doors_open=True, parts="random")
    export.run(home, ["mjcf", "glb"], out, library().load_asset)
    return home, out


def test_the_keyframe_has_parts_as_they_stand_and_sensors_tell(exported):
    home, out = exported
    model = mujoco.MjModel.from_xml_path(str(out / "mjcf" / "apartment.xml"))
    start, data = mujoco.MjData(model), mujoco.MjData(model)
    mujoco.mj_resetDataKeyframe(model, data, 0)
    mujoco.mj_forward(model, start)
    mujoco.mj_forward(model, data)
    wanted = {f"{id}__{name.removeprefix('open.')}__joint": share for id, state in home.states.items()
              for name, share in state.items() if name.startswith("open.")}
    assert wanted
    for k in np.flatnonzero(model.jnt_type != mujoco.mjtJoint.mjJNT_FREE):
        joint = model.joint(int(k))
        value = wanted.get(joint.name, 0.0) * float(joint.range[1])
        assert data.sensor(f"{joint.name}__at").data[0] == pytest.approx(value, abs=1e-6)
    free = [model.body(int(b)).name for b in model.jnt_bodyid[model.jnt_type == mujoco.mjtJoint.mjJNT_FREE]]
    for name in free:
        assert data.body(name).xpos == pytest.approx(start.body(name).xpos, abs=1e-6)
    assert min((contact.dist for contact in data.contact), default=0.0) > -0.002, "nothing opens into anything"
    assert model.ncam == len(home.rooms)


def _texts(model):
    """Custom texts by their names."""
    named = [model.names[k:].split(b"\0")[0].decode() for k in model.name_textadr]
    spans = zip(model.text_adr, model.text_size)
    return dict(zip(named, [bytes(model.text_data[a:a + n]).rstrip(b"\0").decode() for a, n in spans]))


def test_files_say_states_and_affordances(exported):
    home, out = exported
    model = mujoco.MjModel.from_xml_path(str(out / "mjcf" / "apartment.xml"))
    texts = _texts(model)
    raw = (out / "apartment.glb").read_bytes()
    document = json.loads(raw[20:20 + struct.unpack("<I", raw[12:16])[0]])
    extras = {node["extras"]["id"]: node["extras"] for node in document["nodes"] if "id" in node.get("extras", {})}
    for id, names in home.affordances.items():
        assert extras[id]["affordances"] == names
        assert f"affordances={','.join(names)}" in texts[id]
    for id, state in home.states.items():
        assert extras[id]["state"] == state
        assert ("on" not in state) or f"on={int(state['on'])}" in texts[id].split()
    off = {id for id, state in home.states.items() if state.get("on") is False}
    shining = {light["name"]: light["intensity"] for light in document["extensions"]["KHR_lights_punctual"]["lights"]}
    for o in home.objects:
        if f"light_{o.id}" in shining:
            assert (shining[f"light_{o.id}"] == 0) == (o.id in off)
