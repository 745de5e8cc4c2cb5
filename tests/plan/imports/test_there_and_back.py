"""Homes that come back from files of other programs as they were."""

import logging
from pathlib import Path

import pytest
from plan.imports import homes, writers

from apartgen.schemas import consistency
from apartgen.schemas.layout import Layout
from apartgen.stages import check, export
from apartgen.stages.plan import PlanConfig, imports
from apartgen.stages.things.asset import Asset

HOMES = [(name, seed) for seed in range(2) for name in homes.NAMES]
WRITERS = {
    "sh3d": ("home.sh3d", writers.sh3d),
    "roomplan": ("scan.json", writers.roomplan),
    "procthor": ("house.json", writers.procthor),
}


def back(name: str, data: bytes):
    """What is read of a file; it is sound."""
    plan = imports.read(name, data, PlanConfig())
    assert plan is not None and not list(consistency.faults(plan))
    return plan


@pytest.mark.parametrize("name, seed", HOMES)
@pytest.mark.parametrize("format", WRITERS)
def test_rooms_openings_and_furniture_come_back(format: str, name: str, seed: int) -> None:
    home = homes.furnished(name, seed)
    file, write = WRITERS[format]
    read = back(file, write(home))
    assert isinstance(read, Layout) and check.quick(read) == []
    kept = homes.compared(home, read)
    assert kept.iou > 0.97 and kept.openings == []
    spoken = [id for id in kept.lost if format != "roomplan" or id.split(".")[1][:-2] in writers.APPLE]
    assert spoken == [] and kept.moved < 0.01 and kept.turned < 0.01
    assert kept.types or format == "roomplan"  # whose rooms are of five types


def exported(format: str, home: Layout, folder: Path) -> tuple[str, bytes]:
    """A file of a format that is exported, too."""
    pytest.importorskip({"dxf": "ezdxf", "ifc": "ifcopenshell"}.get(format, "json"))

    def box(library: str, id: str) -> Asset:
        return Asset(library, id, id, "plain", (1, 1, 1), [], credit="")

    export.run(home, [format], folder / "out", box)
    (path,) = (folder / "out").glob(f"*.{format}")
    return path.name, path.read_bytes()


@pytest.mark.parametrize("name, seed", HOMES)
@pytest.mark.parametrize("format", ["dxf", "ifc"])
def test_exported_homes_come_back(format: str, name: str, seed: int, tmp_path: Path) -> None:
    home = homes.furnished(name, seed)
    read = back(*exported(format, home, tmp_path))
    assert isinstance(read, Layout) and check.quick(read) == []
    kept = homes.compared(home, read)
    assert kept.iou > 0.99 and kept.openings == [] and kept.types and kept.lost == []
    assert kept.moved < 0.01 and kept.turned < 0.01
    assert (read.height, read.walls) == (home.height, home.walls)


@pytest.mark.parametrize("name, seed", HOMES[:4])
@pytest.mark.parametrize("format", ["sh3d", "dxf", "ifc"])
def test_leaves_of_doors_turn_as_drawn(format: str, name: str, seed: int, tmp_path: Path) -> None:
    home = homes.furnished(name, seed)
    file = ("home.sh3d", writers.sh3d(home)) if format == "sh3d" else exported(format, home, tmp_path)
    assert homes.leaves(home) == homes.leaves(back(*file))


@pytest.mark.parametrize("name, seed", HOMES[:4])
def test_rooms_that_only_walls_draw_are_found(name: str, seed: int, caplog: pytest.LogCaptureFixture) -> None:
    home = homes.furnished(name, seed)
    with caplog.at_level(logging.WARNING, "apartgen"):
        read = back("home.sh3d", writers.sh3d(home, rooms=False))
    kept = homes.compared(home, read)
    assert kept.iou > 0.97 and kept.openings == [] and len(read.rooms) == len(home.rooms)
    assert sum("has no name" in message for message in caplog.messages) == len(home.rooms)
    beds = {room.id for room in read.rooms if room.type == "bedroom"}
    assert {o.room for o in read.objects if o.category == "double_bed"} <= beds


@pytest.mark.parametrize("language", ["de", "fr", "es", "zh"])
def test_names_of_rooms_are_read_in_other_languages(language: str) -> None:
    words = {
        "de": ["Wohnen", "Kind 1", "Kochen", "Bad", "Diele"],
        "fr": ["Séjour", "Chambre 1", "Cuisine", "Salle de bain", "Entrée"],
        "es": ["Salón", "Dormitorio", "Cocina", "Baño", "Pasillo"],
        "zh": ["客厅", "主卧", "厨房", "卫生间", "走廊"],
    }[language]
    types = ["living_room", "bedroom", "kitchen", "bathroom", "hallway"]
    home = homes.furnished("one_bedroom", 0)
    read = back("home.sh3d", writers.sh3d(home, names=dict(zip(types, words))))
    given = [room.type for room in home.rooms]
    assert [room.type for room in read.rooms] == given
