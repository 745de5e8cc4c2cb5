"""The stage: real assets in, an apartment one can walk through out."""

import logging
from collections.abc import Iterable

from apartgen.schemas.errors import Unmet
from apartgen.schemas.retrieve import Furnishing, Retrieve
from apartgen.schemas.walkable import Blocked, Replaced, Report, Step, Walkable
from apartgen.stages.things.carrying import told
from apartgen.stages.walkable import importance, repair
from apartgen.stages.walkable.blocking import missed
from apartgen.stages.walkable.blocking import rooms as rooms_of
from apartgen.stages.walkable.config import WalkableConfig
from apartgen.stages.walkable.kept import Kept
from apartgen.stages.walkable.leaves import building
from apartgen.stages.walkable.lesser import lesser_kinds
from apartgen.stages.walkable.optimize import EPSILON, area_ratio, optimize, thin_out
from apartgen.stages.walkable.parts import Check, Fault
from apartgen.stages.walkable.site import Candidates, Scene, Site, survey
from apartgen.stages.walkable.solids import Solids
from apartgen.stages.walkable.unblock import unblock
from apartgen.stages.walkable.ways import ways

LOG = logging.getLogger("apartgen")


def cleared(previous: Retrieve, config: WalkableConfig, library: Candidates) -> Walkable:
    """The whole stage, one step after another."""
    site = survey(previous, config, Kept(library), importance.needs(previous))
    start: Scene = tuple(told(previous.objects, previous.height))
    parts = _parts(site)
    scene, steps = start, list[Step]()
    for rooms in parts:
        scene, taken = _opened(site, scene, rooms)
        steps += taken
    now = None
    if config.connect:
        now, taken = repair.connect(site, scene)
        scene, steps = now.scene, [*steps, *taken]
    for rooms in parts if config.drop else []:
        scene, taken = thin_out(site, scene, rooms)
        steps += taken
        now = ways(site, scene) if now and taken else now
        scene, taken, now = lesser_kinds(site, scene, rooms, now)
        steps += taken
    faults: list[Fault] = []
    if config.unblock:
        scene, taken, faults = unblock(site, scene, Check(building(previous), Solids(site.library)), now)
        steps += taken
    unreached = missed(site, scene) if now and now.missed else []
    if not config.write_anyway and (short := _shortfalls(site, scene, parts, unreached)):
        raise Unmet(f"{'; '.join(short)} (--write-anyway writes the best scene)")
    for name in unreached:
        LOG.warning("a robot of %.2f m radius does not get to %s", config.robot_radius, name)
    for fault in faults:
        LOG.warning("%s of %s is blocked by %s", fault.part, fault.owner, fault.by)
    report = _report(site, start, scene, steps, unreached)
    report.blocked += [Blocked(**fault._asdict()) for fault in faults]
    fields = {name: getattr(previous, name) for name in Retrieve.model_fields}
    return Walkable(**fields | {"objects": list(scene), "walkable": report})


def _opened(site: Site, scene: Scene, rooms: list[str]) -> tuple[Scene, list[Step]]:
    """Algorithm 2, what is gentle first: people miss a plant or a second cabinet less than a fifth of their sofa, and a
    third chair less than a third of their table.
    """
    config, start = site.config, scene
    steps: list[Step] = []
    for k, spared in enumerate(((0, importance.decoration), (0, importance.anything)), 1) if config.gentle > 0 else ():
        least = config.gentle**k
        scene, taken = optimize(site, scene, rooms, start, least, importance.MAIN)
        steps += taken
        for most, among in (spared, (1, importance.surplus_cabinets)) if config.drop else ():
            scene, taken = thin_out(site, scene, rooms, most, among)
            steps += taken
        scene, taken = optimize(site, scene, rooms, start, least)
        steps += taken
    scene, taken = optimize(site, scene, rooms)
    return scene, [*steps, *taken]


def lacking(home: Walkable, config: WalkableConfig, library: Candidates) -> str:
    """What it falls short of, empty if nothing."""
    site = survey(home, config, Kept(library), importance.needs(home))
    scene = tuple(home.objects)
    return "; ".join(_shortfalls(site, scene, _parts(site), home.walkable.unreached))


def _parts(site: Site) -> list[list[str]]:
    """Rooms whose free floor is looked at together."""
    return [[room] for room in site.floors] if site.config.scope == "rooms" else [list(site.floors)]


def _shortfalls(site: Site, scene: Scene, parts: Iterable[list[str]], unreached: list[str]) -> list[str]:
    """The target, where it is missed, and what the robot does not get to for what is vital to a room."""
    reached = {", ".join(rooms): (area_ratio(site, scene, rooms), site.target(rooms)) for rooms in parts}
    missed = {rooms: (ratio, target) for rooms, (ratio, target) in reached.items() if ratio < target - EPSILON}
    short = "; ".join(f"{rooms}: {ratio:.3f}" for rooms, (ratio, _) in missed.items())
    wanted = ", ".join(dict.fromkeys(f"{target:.4g}" for _, target in missed.values()))
    found = [f"walkable ratio {wanted} can't be met, best reached: {short}; lower --target or ask for less furniture"]
    return found[: bool(short)] + _cut_off(site, scene, unreached)


def _cut_off(site: Site, scene: Scene, unreached: list[str]) -> list[str]:
    if not unreached:
        return []
    ranks = importance.Ranks(site, scene)
    lost = set(unreached) - set(missed(site, tuple(o for o in scene if ranks.of(o) < 3)))
    if not lost:
        return []
    where = {room for name in lost for room in rooms_of(site, scene, name)}
    vital = ", ".join(o.id for o in scene if o.room in where and ranks.of(o) == 3)
    return [f"a robot of {site.config.robot_radius:g} m radius does not get to {', '.join(sorted(lost))}, as "
            f"{', '.join(sorted(where))} can't do without {vital}; ask for larger rooms or less furniture, or give "
            "--no-connect"]


def _swap(name: str, old: Furnishing, new: Furnishing) -> Replaced:
    return Replaced.model_validate({"object": name, "from": old.asset.id, "to": new.asset.id})


def _report(site: Site, start: Scene, scene: Scene, steps: list[Step], unreached: list[str]) -> Report:
    whole = list(site.floors)
    old, new = {o.id: o for o in start}, {o.id: o for o in scene}
    swaps = [name for name, o in old.items() if name in new and new[name].asset != o.asset]
    return Report(
        target=site.target(), before=area_ratio(site, start, whole), after=area_ratio(site, scene, whole),
        rooms={room: area_ratio(site, scene, [room]) for room in site.floors},
        replaced=[_swap(name, old[name], new[name]) for name in swaps],
        moved=list(dict.fromkeys(s.object for s in steps if s.action == "nudge" and s.object in new)),
        dropped=[name for name in old if name not in new], unreached=unreached, steps=steps,
    )
