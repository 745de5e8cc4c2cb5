"""GAPartNet or PartNet-Mobility: numbered folders of URDF objects with part classes; scaled to real sizes."""

from collections.abc import Iterator
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from apartgen.stages.retrieve.reading import limits, tree, urdf
from apartgen.stages.retrieve.reading.fitting import fitted
from apartgen.stages.retrieve.reading.limits import Broken
from apartgen.stages.retrieve.reading.model import Model, Motion, Part, asset
from apartgen.stages.retrieve.reading.pieces import Array
from apartgen.stages.retrieve.reading.source import Source
from apartgen.stages.retrieve.reading.tree import Body
from apartgen.stages.things.asset import Asset
from apartgen.stages.things.categories import labelled
from apartgen.stages.things.words import OTHER

URDFS = ("mobility_annotation_gapartnet.urdf", "mobility_relabel_gapartnet.urdf", "mobility.urdf")
ANNOTATION = "link_annotation_gapartnet.json"
TURN = np.diag([-1.0, -1.0, 1.0])
"""In the root link's frame, after the fixed base joint of rpy (π/2, 0, -π/2), objects are z up and face -x."""
LENGTHS = {
    "Door": 2.0,
    "Laptop": 0.35,
    "Suitcase": 0.6,
    "Box": 0.4,
    "CoffeeMachine": 0.4,
    "KitchenPot": 0.25,
    "Keyboard": 0.45,
    "Remote": 0.2,
    "Phone": 0.15,
    "Printer": 0.45,
    "Camera": 0.12,
    "Toaster": 0.3,
}
"""Longest side of what is no furniture, m."""
CABINET = "StorageFurniture"

def assets(root: Path) -> Iterator[Source]:
    """Every object folder below `root`, wherever its URDF lies."""
    found = {file.parent for name in URDFS for file in root.rglob(name)}
    for folder in sorted(found, key=lambda path: (len(path.name), path.name)):
        yield Source(str(folder.relative_to(root)) if folder != root else folder.name, partial(_load, folder, root))


def _load(folder: Path, root: Path) -> Asset:
    limits.inside(root, folder)
    file = next(folder / name for name in URDFS if (folder / name).exists())
    robot = urdf.read(file, folder)
    bodies = _limited(robot, folder)
    classes = _classes(folder)
    parts = [_annotated(part, bodies, classes) for part in tree.parts(bodies)]
    kind, scale = _real(_model_category(folder), bodies, parts)
    name = folder.name if folder == root else str(folder.relative_to(root))
    made = asset(
        Model(
            name,
            kind,
            parts,
            style=_model_category(folder),
            turn=TURN,
            scale=scale,
            credit=f"PartNet-Mobility model {folder.name} (terms of PartNet and ShapeNet; no redistribution)",
        ),
        "",
    )
    return made


def _json(path: Path) -> Any:
    return limits.parsed(path) if path.exists() else None


def _model_category(folder: Path) -> str:
    meta = _json(folder / "meta.json")
    return str(meta.get("model_cat") or "") if isinstance(meta, dict) else ""


def _classes(folder: Path) -> dict[str, str]:
    """GAPartNet class of each link that is a part; an empty category marks links that are none.

    Without the annotation, `semantics.txt` (link, joint kind, meaning) tells doors, drawers, lids and knobs apart.
    """
    rows = _json(folder / ANNOTATION)
    if isinstance(rows, list):
        return {str(r["link_name"]): str(r["category"]) for r in rows if isinstance(r, dict) and r.get("category")}
    path = folder / "semantics.txt"
    lines = [line.split() for line in limits.text(path).splitlines()] if path.exists() else []
    return {words[0]: _meaning(words[1], words[2]) for words in lines if len(words) >= 3}


def _meaning(joint: str, meaning: str) -> str:
    if joint == "slider":
        return "slider_button" if "button" in meaning else "slider_lid" if "lid" in meaning else "slider_drawer"
    if joint == "hinge":
        return next(
            (
                c
                for word, c in (("lid", "hinge_lid"), ("knob", "hinge_knob"), ("handle", "hinge_handle"))
                if word in meaning
            ),
            "hinge_door",
        )
    return "line_fixed_handle" if "handle" in meaning else ""


def _limited(robot: urdf.Robot, folder: Path) -> list[Body]:
    """Hinges without limits in the URDF take those of `mobility_v2.json`, which are in degrees."""
    rows = _json(folder / "mobility_v2.json")
    degrees = (
        {f"link_{r['id']}": r for r in rows if isinstance(r, dict) and "id" in r} if isinstance(rows, list) else {}
    )
    out = []
    for body in robot.bodies:
        limit = degrees.get(body.name, {}).get("jointData") or {}
        limit = limit.get("limit") or {} if isinstance(limit, dict) else {}
        free = (
            body.motion is not None
            and body.motion.type == "hinge"
            and body.motion.range == (-tree.ENDLESS, tree.ENDLESS)
        )
        if free and body.motion is not None and not limit.get("noLimit", True) and {"a", "b"} <= set(limit):
            span = sorted(float(np.radians(float(limit[key]))) for key in ("a", "b"))
            body = replace(body, motion=replace(body.motion, range=(span[0], span[1])))
        out.append(body)
    return out


def _annotated(part: Part, bodies: list[Body], classes: dict[str, str]) -> Part:
    if part.motion is None:
        return part
    rows = {body.name: i for i, body in enumerate(bodies)}
    under = [b for b in bodies if b.parent == rows.get(part.name) and "handle" in classes.get(b.name, "") and b.pieces]
    handle = np.concatenate([p.vertices for b in under for p in b.pieces]) if under else None
    grip = None if handle is None else (handle.min(0) + handle.max(0)) / 2
    kind = next((classes[b.name] for b in under), "")
    return replace(part, motion=_closed(part.motion, classes.get(part.name, "")), handle=grip, grip=kind)


def _closed(motion: Motion, kind: str) -> Motion:
    return replace(motion, part=kind) if kind else motion


def _real(name: str, bodies: list[Body], parts: list[Part]) -> tuple[str, float]:
    """Category and metres per unit: models come in a unit sphere, and `bounding_box.json` is no better."""
    used = [p.vertices[np.unique(p.faces)] for body in bodies for p in body.pieces if len(p.faces)]
    if not used:
        raise Broken("has no faces")
    points = np.concatenate(used)
    if not np.isfinite(points).all():
        raise Broken("vertices that are not finite numbers")
    extents: Array = np.ptp(points, axis=0)
    candidates = labelled("gapartnet").get(_storage(parts) if name in (CABINET, "") else name, ())
    if not candidates:
        return OTHER, LENGTHS.get(name, 0.5) / max(float(extents.max()), 1e-9)
    return fitted(extents, candidates)


def _storage(parts: list[Part]) -> str:
    """What label a cabinet has by what most of its parts do."""
    slides = sum(part.motion.type == "slide" for part in parts if part.motion)
    hinges = sum(part.motion.type == "hinge" for part in parts if part.motion)
    return CABINET if slides + hinges == 0 else f"{CABINET} with {'drawers' if slides > hinges else 'leaves'}"
