"""Whole flats in the simulator: one on every run, twenty of as many sentences when there are minutes (`-m slow`).

APARTGEN_KEEP names a folder where the twenty are kept, or found.
"""

import os
from pathlib import Path

import commandline
import mujoco
import pytest
from export import nav2maps, physics, test_coincide
from test_acceptance import PROMPTS

from apartgen.schemas import artifact
from apartgen.schemas.walkable import Walkable

SECONDS, DRIFT, GAIN, CALM = 5.0, 0.02, 0.1, 0.01
"""How long a flat is left alone; the most that anything may go, m, and gain, J; its greatest speed at the end."""


@pytest.fixture(scope="module", params=["example", *(pytest.param(k, marks=pytest.mark.slow) for k in range(20))])
def made(request, make, library, tmp_path_factory):
    if request.param == "example":
        return request.getfixturevalue("flat")
    folder = Path(os.environ.get("APARTGEN_KEEP") or tmp_path_factory.mktemp("flats")) / f"{request.param:02d}"
    if not (folder / "walkable.json").exists():
        seed = str(request.param)
        done = commandline.program("make", PROMPTS[request.param], "-o", f"{folder}/", "--seed", seed, "--format=svg")
        assert done.code == 0, done.err
    return make(artifact.read(folder / "walkable.json", Walkable).body, library, ("mjcf", "nav2"))


@pytest.fixture
def model(made):
    return mujoco.MjModel.from_xml_path(str(made.folder / "mjcf" / "apartment.xml"))


def test_nothing_moves_and_nothing_gains_energy(model):
    found = physics.rest(model, SECONDS)
    assert found.drift < DRIFT and found.energy < GAIN and found.speed < CALM, found


def test_hand_force_brings_every_joint_to_both_ends(model):
    assert not physics.stuck(model)


def test_no_part_enters_its_own_object(made):
    assert not physics.rubbing(made.folder / "mjcf" / "apartment.xml")


def test_what_is_seen_is_felt(made):
    assert not test_coincide.faults(made.scene, made.folder)


def test_the_map_is_as_free_as_the_floor(made):
    measured, wanted = nav2maps.free_ratios(made.folder / "nav2", made.scene.home)
    assert measured == pytest.approx(wanted, abs=0.01)
