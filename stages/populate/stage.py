"""The stage: a furnished home in, one that people live in out."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple, Protocol

import numpy as np

from apartgen.schemas import populate
from apartgen.schemas.carrying import FLOOR, WALL
from apartgen.schemas.plan import Room
from apartgen.schemas.populate import Inside, Populate, Thing
from apartgen.schemas.retrieve import AssetKey, Furnishing, Retrieve
from apartgen.schemas.walkable import Walkable
from apartgen.stages import seeds
from apartgen.stages.populate import arrange, reached, rules, states, walls
from apartgen.stages.populate.arrange import Put
from apartgen.stages.populate.boards import Board, boards, offers
from apartgen.stages.populate.config import PopulateConfig
from apartgen.stages.populate.rules import Rule
from apartgen.stages.things import categories, small
from apartgen.stages.things.asset import Asset
from apartgen.stages.things.carrying import told
from apartgen.stages.things.receptacles import Receptacle
from apartgen.stages.things.small import Design
from apartgen.stages.use import household

LIBRARY = "parametric"
PEOPLE = (1, 4)
"""As many are reckoned with at least and at most."""
_DRAWS = 20
"""So many times as often as models are wanted they are drawn, for all to differ."""


class Library(Protocol):
    """Where assets are found."""

    def load_asset(self, library: str, id: str) -> Asset:
        """The asset of a library by id."""


class Home(NamedTuple):
    """What all rooms share: the models of things that this home has, how many live here, and how full it is."""

    models: dict[str, list[Design]]
    people: int
    density: float


def populated(previous: Retrieve, config: PopulateConfig, rng: np.random.Generator, library: Library) -> Populate:
    """Room by room, first the walls, then the furniture."""
    before = previous.model_copy(update={"objects": told(previous.objects, previous.height)})
    offered = offers(before, library.load_asset)
    people = int(np.clip(household.sleepers(before) or 2, *PEOPLE))
    home = Home(_models(seeds.lane(rng, "models")), people, config.density)
    names = _Names(o.id for o in before.objects)
    things: list[Thing] = []
    for room in before.rooms:
        hung = _hung(before, room, home, names, rng) if config.walls else []
        here = boards(before, room.id, offered, hung, library.load_asset)
        groups = furnished(here, rules.table().get(room.base, ()), home, seeds.lane(rng, room.id))
        things += [*_recorded(room.id, groups, names), *hung]
    things = reached.held(before, things, offered, library.load_asset) if config.grasps else things
    told_of = states.said(before, [*before.objects, *things], offered, config, seeds.lane(rng, "states"))
    return _body(before, things, offered, told_of)


def _hung(before: Retrieve, room: Room, home: Home, names: "_Names", rng: np.random.Generator) -> list[Thing]:
    found = walls.hung(before, room, home.models, home.density, seeds.lane(rng, f"walls {room.id}"))
    return [_thing(names.new(room.id, h.design.kind.name), room.id, h.design, False, h.center, h.yaw, WALL)
            for h in found]


def _body(before: Retrieve, things: list[Thing], offered: dict[str, tuple[Receptacle, ...]],
          told_of: states.Said) -> Populate:
    fields = {name: getattr(before, name) for name in Retrieve.model_fields}
    report = before.walkable if isinstance(before, Walkable) else None
    used = {id: [_receptacle(place) for place in places] for id, places in offered.items() if places}
    return Populate(**fields | {"objects": [*before.objects, *things], "walkable": report, "receptacles": used}
                    | told_of._asdict())


def _receptacle(place: Receptacle) -> populate.Receptacle:
    return populate.Receptacle(name=place.name, kind=place.kind, polygon=place.polygon(), z=round(place.z, 4),
                               clearance=round(place.room, 4), part=place.part or None)


def _models(rng: np.random.Generator) -> dict[str, list[Design]]:
    return {name: _unlike(kind, own) if kind.fixed else [small.drawn(kind, own) for _ in range(kind.designs)]
            for name, kind in small.TABLE.items() for own in [seeds.lane(rng, name)]}


def _unlike(kind: small.Small, rng: np.random.Generator) -> list[Design]:
    """Models of what hangs in sight of one another: none looks like another while there are other looks."""
    found: dict[tuple[str, ...], Design] = {}
    for _ in range(_DRAWS * kind.designs):
        design = small.drawn(kind, rng)
        found.setdefault(small.look(design), design)
        if len(found) == kind.designs:
            break
    return list(found.values())


class _Names:
    """Ids that nothing has yet."""

    def __init__(self, taken: Iterator[str]) -> None:
        self.taken, self.count = set(taken), dict[str, int]()

    def new(self, room: str, category: str) -> str:
        """An id of a thing in a room."""
        while True:
            base = f"{room}_{category}"
            self.count[base] = self.count.get(base, 0) + 1
            name = f"{base}_{self.count[base]}"
            if name not in self.taken:
                self.taken.add(name)
                return name


def furnished(here: list[Board], lines: Sequence[Rule], home: Home, rng: np.random.Generator) -> list[list[Put]]:
    """What the rules put on a room's boards, in groups that were put together."""
    found: list[list[Put]] = []
    for k, rule in enumerate(lines):
        own = seeds.lane(rng, f"{k} {' '.join(rule.put)}")
        if own.random() < min(1.0, rule.chance * max(home.density, 0.0)):
            found += _followed(rule, here, home, own)
    return found


def _followed(rule: Rule, here: list[Board], home: Home, rng: np.random.Generator) -> Iterator[list[Put]]:
    low, high = rule.n
    wanted = int(rng.integers(low, high + 1)) * (home.people if rule.per == "person" else 1)
    left = int(wanted * home.density + rng.random())
    chosen = _chosen(rule, here, rng)
    while left > 0:
        size = 2 if rule.how == "pair" else 1 if rule.how in ("each", "one") else min(left, rule.of)
        put = next((put for board in chosen if (put := _put(rule, board, size, home, rng))), [])
        if not put:
            return
        yield put
        left -= len(put)
        if rule.mixed:
            chosen = [chosen[i] for i in rng.permutation(len(chosen))]


def _chosen(rule: Rule, here: list[Board], rng: np.random.Generator) -> list[Board]:
    """The boards of a rule, in the order in which they are tried; rims at the front are the last for what stands at the
    back.
    """
    beacons = [board.owner for board in here if rule.near and board.owner.category in categories.used_for(rule.near)]
    tiers: list[list[Board]] = []
    for at in rule.at:
        names, kind = rules.spots(at)
        fit = [b for b in here if b.owner.category in names and _kind(b) == kind]
        fit = [fit[i] for i in rng.permutation(len(fit))]
        if kind == "drawer":
            fit.sort(key=lambda board: -board.place.z)
        if beacons:
            fit.sort(key=lambda board: min(_distance(board.owner, beacon) for beacon in beacons))
        tiers.append(fit)
    every = [board for tier in tiers for board in tier]
    if rule.where == "back":
        every.sort(key=lambda board: board.place.kind == "top" and board.place.lo[0] > 0)
    return [every[i] for i in rng.permutation(len(every))] if rule.mixed else every


def _kind(board: Board) -> str:
    return "floor" if board.place.name.startswith("floor") else board.place.kind


def _distance(a: Furnishing, b: Furnishing) -> float:
    return round(float(np.hypot(a.center[0] - b.center[0], a.center[1] - b.center[1])), 3)


def _put(rule: Rule, board: Board, n: int, home: Home, rng: np.random.Generator) -> list[Put]:
    name = rule.put[int(rng.integers(len(rule.put)))]
    models = home.models[name]
    designs = [models[int(rng.integers(len(models)))] for _ in range(n)]
    lying = rule.lying and models[0].kind.rests
    if rule.dish:
        return arrange.dished(home.models[rule.dish][0], designs, board, rule.where, rule.turned, rng)
    match rule.how:
        case "row":
            return arrange.row(designs, lying, board, rule.where, rng)
        case "pair":
            pair = arrange.row([designs[0]] * 2, lying, board, rule.where, rng)
            return pair if len(pair) == 2 else []
        case "grid":
            return arrange.grid([designs[0]] * n, lying, board, rule.where, rng)
        case "stack":
            return arrange.stack(designs, lying, board, rule.where, rule.turned, rng)
        case _:
            return arrange.one(designs[0], lying, board, rule.where, rule.turned, rng)


def _recorded(room: str, groups: list[list[Put]], names: _Names) -> list[Thing]:
    things: list[Thing] = []
    for group in groups:
        ids = [names.new(room, put.design.kind.name) for put in group]
        for put, id in zip(group, ids):
            owner = put.board.owner
            center, yaw = put.board.world(put.spot, put.design.size_of(put.lying)[2])
            floor = _kind(put.board) == "floor"
            on = ids[put.under] if put.under >= 0 else FLOOR if floor else owner.id
            inside = None if floor else Inside(object=owner.id, receptacle=put.board.place.name)
            things.append(_thing(id, room, put.design, put.lying, center, yaw, on, inside))
    return things


def _thing(
    id: str, room: str, design: Design, lying: bool, center: tuple[float, float, float], yaw: float, on: str,
    inside: Inside | None = None,
) -> Thing:
    x, y, z = (round(value, 5) for value in center)
    return Thing(
        id=id, stage="populate", room=room, category=design.kind.name, center=(x, y, z), size=design.size_of(lying),
        yaw=round(yaw, 5), on=on, asset=AssetKey(library=LIBRARY, id=design.id(lying)), in_=inside,
    )
