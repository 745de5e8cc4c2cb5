"""The figures of docs/populate.md: `python docs/experiments/things/measure.py WHAT HOMES.jsonl [FIRST LAST]`.

HOMES is what `apartgen populate` wrote for the list of `--prompts`. WHAT is one of: prompts (fifty of ten kinds on the
standard output), counts, walls, palette, stands; begun, settled, parts, taken (in MuJoCo, a line of JSON a home); alone
(no homes).
"""

import json
import statistics
import sys
import tempfile
import time
from collections import Counter, defaultdict
from collections.abc import Callable, Iterator, Sequence
from itertools import combinations
from pathlib import Path
from typing import Any

import mujoco
import numpy as np
from shapely import Polygon

TESTS = Path(__file__).parents[3] / "tests"
sys.path[:0] = [str(TESTS), str(TESTS / "populate")]

import handling  # noqa: E402
import test_grasps  # noqa: E402

from apartgen.schemas import artifact  # noqa: E402
from apartgen.schemas.populate import Populate  # noqa: E402
from apartgen.stages import retrieve  # noqa: E402
from apartgen.stages.populate import faces  # noqa: E402
from apartgen.stages.space import boxes  # noqa: E402
from apartgen.stages.things import small  # noqa: E402
from apartgen.stages.things.grasps import WIDEST, holds  # noqa: E402

KINDS = ("studio", "one-bedroom flat", "two-bedroom flat", "three-bedroom flat", "four-bedroom flat",
         "two-bedroom house", "loft", "two-bedroom flat with a balcony", "three-bedroom house",
         "two-bedroom flat with an open kitchen")
FIRST_SEED, HOMES = 115500, 50
ROOMS = ("bedroom", "living_room", "kitchen", "bathroom")
SOFT = ("curtain", "rug", "ceiling_lamp")
LIBRARY = retrieve.open_libraries()
SLEEP = int(mujoco.mjtEnableBit.mjENBL_SLEEP)


def prompts() -> None:
    for k in range(HOMES):
        print(json.dumps({"id": f"h{k:02d}", "prompt": KINDS[k % len(KINDS)], "seed": FIRST_SEED + k}))


def _mass(o: Any) -> float:
    return sum(link.mass for link in LIBRARY.load_asset(o.asset.library, o.asset.id).links)


def _small(home: Populate) -> list[Any]:
    return [o for o in home.objects if getattr(o, "stage", "") == "populate"]


def counts(homes: Sequence[Populate]) -> None:
    """Medians by type of room: objects, what is seen with all shut, of a hand's size, and of these what is free."""
    found, hand, free = defaultdict(list), 0, 0
    for home in homes:
        shut = {(id, p.name) for id, places in home.receptacles.items() for p in places if p.part}
        for room in home.rooms:
            here = [o for o in home.objects if o.room == room.id]
            hidden = sum((i.object, i.receptacle) in shut for o in here if (i := getattr(o, "in_", None)))
            held = [o for o in here if max(o.size) <= 0.4 and _mass(o) <= 5]
            loose = [o for o in held if o.on != "wall" and o.category not in ("ceiling_lamp", "wall_lamp")]
            hand, free = hand + len(held), free + len(loose)
            found[room.base].append((len(here), len(here) - hidden, len(held), len(loose)))
    for base in ROOMS:
        print(base, len(found[base]), "rooms:", *np.median(found[base], axis=0))
    print(f"free {free / hand:.3f} of {hand}; objects a home", statistics.median(len(h.objects) for h in homes))


def walls(homes: Sequence[Populate]) -> None:
    """Walls of living rooms from 1.2 m with nothing at the height of eyes on 2 m, or on all of them; pictures."""
    tally: Counter[str] = Counter()
    for home in homes:
        pictures = [o.asset.id.split("/") for o in home.objects if o.category == "picture"]
        worn = [small.worn(small.TABLE["picture"], int(seed)) for _, _, _, seed in pictures]
        looks = {(style, w["art"], w["ink"]) for (_, style, _, _), w in zip(pictures, worn)}
        tally.update(pictures=len(pictures), alike=len(pictures) - len(looks))
        for room in (room for room in home.rooms if room.base == "living_room"):
            here = [o for o in home.objects if o.room == room.id and o.category not in ("light_switch", "socket")]
            for face in (f for f in faces.faces_of(home, room, here) if f.length >= 1.2):
                tally.update(walls=1, plain=int(_plain(face) >= min(2.0, face.length - 0.02)))
    print(dict(tally))


def _plain(face: faces.Face) -> float:
    """The longest stretch of a wall that nothing covers between 1.3 and 1.7 m."""
    at = longest = 0.0
    cuts = sorted((a, b) for a, b, low, high in face.covered if low < 1.7 and high > 1.3)
    for a, b in [*cuts, (face.length, face.length)]:
        longest, at = max(longest, min(a, face.length) - at), max(at, b)
    return longest


def palette(homes: Sequence[Populate]) -> None:
    rooms = [next(room for room in home.rooms if room.base == "living_room") for home in homes]
    seen = [(home.finishes[room.id].floor, home.finishes[room.id].wall) for home, room in zip(homes, rooms)]
    pairs = [a == b for a, b in combinations(seen, 2)]
    print(f"{sum(pairs)} of {len(pairs)} pairs share floor and wall: {np.mean(pairs):.4f}")


def stands(homes: Sequence[Populate]) -> None:
    """Furniture, but what hangs or lies, whose box is more than 1 mm outside its room."""
    tried, out = 0, []
    for home in homes:
        rooms = {room.id: Polygon(room.polygon).buffer(1e-3, join_style="mitre") for room in home.rooms}
        solid = [o for o in home.objects if getattr(o, "stage", "") != "populate" and o.category not in SOFT]
        for o, corners in zip(solid, boxes.corners(boxes.of(solid))):
            tried += 1
            out += [o.id] * (Polygon(corners).difference(rooms[o.room]).area > 1e-9)
    print(f"{len(out)} of {tried} stand in a wall:", *out)


def begun(home: Populate, folder: Path) -> dict[str, Any]:
    """Contacts deeper than 1 mm at the start, and those of parts led through their range, loose things aside."""
    model = handling.model(home, LIBRARY.load_asset, folder)
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    row = {"deep": _deep(model, data)}
    loose = model.jnt_bodyid[model.jnt_type == mujoco.mjtJoint.mjJNT_FREE]
    aside = np.isin(model.geom_bodyid, loose)
    model.geom_contype[aside] = model.geom_conaffinity[aside] = 0
    parts = [j for j in range(model.njnt) if model.jnt_type[j] != mujoco.mjtJoint.mjJNT_FREE]
    return row | {"free": len(loose), "parts": len(parts), "meet": [m for j in parts for m in _met(model, data, j)]}


def _met(model: mujoco.MjModel, data: mujoco.MjData, joint: int) -> list[list[str]]:
    """What a part meets deeper than 1 mm at seven places of its range, all others being shut."""
    at, found = model.jnt_qposadr[joint], []
    shut, (low, high) = data.qpos[at], model.jnt_range[joint]
    for share in np.linspace(0.1, 1.0, 7):
        data.qpos[at] = share * (high if abs(high) > abs(low) else low)
        mujoco.mj_kinematics(model, data)
        mujoco.mj_collision(model, data)
        found += _deep(model, data)
    data.qpos[at] = shut
    return found


def _deep(model: mujoco.MjModel, data: mujoco.MjData) -> list[list[str]]:
    return [[model.body(model.geom_bodyid[geom]).name for geom in contact.geom]
            for contact in data.contact[: data.ncon] if contact.dist < -1e-3]


def settled(home: Populate, folder: Path) -> dict[str, Any]:
    """Ten seconds with everything awake, and with what rests asleep: what moved, and steps a CPU second."""
    model = handling.model(home, LIBRARY.load_asset, folder)
    loose = [int(model.jnt_bodyid[j]) for j in range(model.njnt) if model.jnt_type[j] == mujoco.mjtJoint.mjJNT_FREE]
    row: dict[str, Any] = {"free": len(loose)}
    for name, flag in (("awake", 0), ("asleep", SLEEP)):
        model.opt.enableflags = int(model.opt.enableflags) & ~SLEEP | flag
        data = mujoco.MjData(model)
        mujoco.mj_forward(model, data)
        deep = sum(contact.dist < -1e-3 for contact in data.contact[: data.ncon])
        at, turn, begun, steps = data.xpos[loose].copy(), data.xquat[loose].copy(), time.process_time(), 0
        while data.time < 10:
            mujoco.mj_step(model, data)
            steps += 1
        taken = time.process_time() - begun
        far = np.linalg.norm(data.xpos[loose] - at, axis=1)
        turned = 2 * np.arccos(np.clip(np.abs((data.xquat[loose] * turn).sum(1)), 0, 1))
        moved = int(((far > 0.01) | (turned > np.radians(5))).sum())
        row |= {"deep": deep, name: {"moved": moved, "farthest": float(far.max()), "a second": round(steps / taken)}}
    return row


def parts(home: Populate, folder: Path) -> dict[str, Any]:
    moved = list(handling.opened(home, handling.model(home, LIBRARY.load_asset, folder)))
    return {"parts": len(moved), "things": sum(one.things for one in moved), "jam": sum(one.jams for one in moved),
            "lose": sum(bool(one.fallen) for one in moved)}


def taken(home: Populate, folder: Path) -> dict[str, Any]:
    """Every second thing up to 75 mm thick and 1 kg, taken from where it is by one of its grasps."""
    model, rested = handling.model_with_hand(home, LIBRARY.load_asset, folder)
    held, under = handling.contents(home), handling.under_boards(home)
    part = {id: joint for (joint, _), ids in held.items() for id in ids}
    along = {joint: ids for (joint, _), ids in held.items()}
    fit = [o for o in _small(home) if o.on != "wall" and min(o.size) <= WIDEST and _mass(o) <= 1][::2]
    outcomes = [(any(grasp.clear for grasp in o.grasps), not handling.taken(
        model, rested, o, part.get(o.id), along.get(part.get(o.id), ()), o.id in under)) for o in fit]
    return {"things": len(fit), "taken": sum(got for _, got in outcomes), "clear": sum(told for told, _ in outcomes),
            "clear and taken": sum(told and got for told, got in outcomes)}


def alone() -> None:
    """Eight models of each kind, standing and lying, by the grasp named first."""
    tried: dict[str, list[bool]] = defaultdict(list)
    for seed in range(81, 89):
        rng = np.random.default_rng(seed)
        for name, kind in small.TABLE.items():
            design = small.drawn(kind, rng)
            for laid in (False, True) if kind.rests else (False,):
                asset = LIBRARY.load_asset("parametric", design.id(laid))
                if not kind.fixed and min(asset.size) <= WIDEST and asset.links[0].mass <= 1:
                    tried[name].append(test_grasps.lifted(asset, holds(asset.links[0])[0]))
    print(len(tried), "kinds;", sum(map(sum, tried.values())), "of", sum(map(len, tried.values())), "models held")


def _each(measure: Callable[[Populate, Path], dict[str, Any]], homes: Sequence[Populate]) -> Iterator[dict[str, Any]]:
    for home in homes:
        with tempfile.TemporaryDirectory() as folder:
            yield measure(home, Path(folder) / "home")


def main(what: str, file: str = "", *span: str) -> None:
    if what in ("prompts", "alone"):
        return {"prompts": prompts, "alone": alone}[what]()
    lines = Path(file).read_bytes().splitlines()[slice(*map(int, span or ("0", "1000000")))]
    homes = [artifact.parse(line, file, Populate).body for line in lines]
    if what in ("counts", "walls", "palette", "stands"):
        return {"counts": counts, "walls": walls, "palette": palette, "stands": stands}[what](homes)
    for row in _each({"begun": begun, "settled": settled, "parts": parts, "taken": taken}[what], homes):
        print(json.dumps(row), flush=True)


if __name__ == "__main__":
    main(*sys.argv[1:])
