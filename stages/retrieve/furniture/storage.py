"""Wardrobes, chests, nightstands, sideboards, cabinets."""

from apartgen.stages.retrieve.furniture import cases, fronts
from apartgen.stages.retrieve.furniture.body import Body
from apartgen.stages.retrieve.furniture.cases import Cell
from apartgen.stages.retrieve.furniture.designs import design
from apartgen.stages.retrieve.furniture.kit import Kit
from apartgen.stages.retrieve.furniture.looks import CASE_STYLES, Look, look


@design("wardrobe", *CASE_STYLES)
def wardrobe(kit: Kit) -> None:
    """Hanging space behind doors, drawers under some of them."""
    own = look(kit.style, kit.taste())
    foot = min(cases.base_height(own, kit.h), 0.12)
    own_x = kit.x
    cap = 0.04 if own.overhang else 0.02
    below = kit.style in ("scandi", "classic", "shaker") and kit.rng.random() < 0.7
    columns = cases.door_columns(kit, kit.w)
    for column in columns:
        column[0] = Cell(column[0].kind, 1.0, 1)
        if below:
            column[:] = [Cell(column[0].kind, 1.0, 0), Cell("drawer", 0.16)]
    inset = own.overhang
    y = (kit.y[0] + inset, kit.y[1] - inset)
    out = fronts.projection(own)
    cases.stand(kit, own, (own_x[0], own_x[1] - out), y, foot)
    cases.cabinet(kit, own, own_x, y, (foot, kit.h - cap), columns, cases.door_widths(kit, kit.w))
    cases.crown(kit, own, (kit.h - cap, kit.h))
    _rail(kit, y, kit.h - cap - 0.11, below)


def _rail(kit: Kit, y: tuple[float, float], z: float, whole: bool) -> None:
    shelf = 0.0 if whole else 0.02
    x = -0.02
    kit.base.rod("chrome", (x, y[0] + cases.BOARD, z - shelf), (x, y[1] - cases.BOARD, z - shelf), 0.0125)


@design("sliding_wardrobe", "modern", "scandi", "mirrored", "japandi", "glass", "industrial")
def sliding_wardrobe(kit: Kit) -> None:
    """Two to four doors that run on two tracks in front of the carcass."""
    plain = {"mirrored": "modern", "glass": "industrial"}.get(kit.style, kit.style)
    own = look(plain, kit.taste(plain)).with_(handle="none", base="plinth", leg="graphite")
    front = {"mirrored": "mirror", "glass": "smoked_glass"}.get(kit.style, own.front)
    own = own.with_(front=front, profile="slab" if kit.style != "japandi" else "woven")
    y, z, tracks = kit.y, (0.06, kit.h - 0.05), 0.085
    kit.base.box(own.leg, (kit.x[0] + 0.02, kit.x[1] - 0.03), (y[0] + 0.01, y[1] - 0.01), (0, z[0]))
    inner_y, inner_z, back = cases.carcass(kit, own, (kit.x[0], kit.x[1] - tracks), y, z)
    _surround(kit, own, tracks, z)
    n = 2 if kit.w < 2.1 else 3 if kit.w < 2.75 else 4
    bays = 2 if n != 3 else 3
    for i in range(bays):
        lo = inner_y[0] + i * (inner_y[1] - inner_y[0]) / bays
        hi = lo + (inner_y[1] - inner_y[0]) / bays
        if i:
            kit.base.box(own.body, (back, kit.x[1] - tracks - 0.002), (lo - 0.009, lo + 0.009), inner_z)
        room = (lo + (0.01 if i else 0.001), hi - (0.01 if i < bays - 1 else 0.001))
        cases.shelves(kit, own, (back, kit.x[1] - tracks - 0.02), room, inner_z, 4 if i == 0 else 1)
        if i:
            kit.base.rod("chrome", (0, room[0], inner_z[1] - 0.1), (0, room[1], inner_z[1] - 0.1), 0.0125)
    _sliding_doors(kit, own, n, inner_y, z)


def _surround(kit: Kit, own: Look, tracks: float, z: tuple[float, float]) -> None:
    b, x = kit.base, (kit.x[1] - tracks, kit.x[1])
    for side in ((kit.y[0], kit.y[0] + cases.BOARD), (kit.y[1] - cases.BOARD, kit.y[1])):
        b.box(own.body, x, side, z)
    inner = (kit.y[0] + cases.BOARD, kit.y[1] - cases.BOARD)
    b.box(own.body, x, inner, (z[0], z[0] + cases.BOARD))
    b.box(own.body, x, inner, (z[1] - 0.03, z[1]))
    b.box(own.top, kit.x, kit.y, (z[1], kit.h))


def _sliding_doors(kit: Kit, own: Look, n: int, y: tuple[float, float], z: tuple[float, float]) -> None:
    lap, clear = 0.04, 0.003
    wide = (y[1] - y[0] - 2 * clear + (n - 1) * lap) / n
    for i in range(n):
        lo = y[0] + clear + i * (wide - lap)
        ahead = i % 2 == 0
        x = (kit.x[1] - 0.03, kit.x[1] - 0.008) if ahead else (kit.x[1] - 0.065, kit.x[1] - 0.043)
        # Doors of one track are two apart: those that share one have half of the gap between them each.
        sign = 1 if i == 0 or (n == 4 and i == 1) else -1
        alone = n == 2 or (n == 3 and i == 1)
        travel = 0.98 * (wide - lap) if alone else 0.48 * (wide - 2 * lap)
        fronts.sliding(kit, own, x, (lo, lo + wide), (z[0] + 0.02, z[1] - 0.033), travel, sign)


@design("chest", *CASE_STYLES)
def chest(kit: Kit) -> None:
    """Drawers, deeper towards the floor; the top row is split when it is wide."""
    own = look(kit.style, kit.taste())
    rows = max(2, round(kit.h / 0.21))
    lower = [Cell("drawer", 1.0 + 0.12 * i) for i in range(rows)]
    if kit.w > 1.15:
        cases.unit(kit, own, [lower, lower])
        return
    cases.unit(kit, own, [lower])


@design("nightstand", *CASE_STYLES)
def nightstand(kit: Kit) -> None:
    """One or two drawers, sometimes over an open shelf."""
    own = look(kit.style, kit.taste())
    if kit.h - cases.base_height(own, kit.h) > 0.42 and kit.rng.random() < 0.5:
        column = [Cell("drawer"), Cell("open", 1.3, 0)]
    elif kit.h - cases.base_height(own, kit.h) > 0.3:
        column = [Cell("drawer"), Cell("drawer", 1.15)]
    else:
        column = [Cell("drawer")]
    cases.unit(kit, own, [column])


@design("sideboard", *CASE_STYLES)
def sideboard(kit: Kit) -> None:
    """Doors, with a column of drawers in wider ones or drawers above."""
    own = look(kit.style, kit.taste())
    above = [Cell("drawer", 0.3)] if kit.style in ("shaker", "classic", "industrial") else []
    columns, widths = cases.door_columns(kit, kit.w, above=above), cases.door_widths(kit, kit.w)
    if not above and len(columns) > 1:
        middle = len(columns) // 2 if len(columns) > 2 else 1
        columns[middle] = [Cell("drawer"), Cell("drawer", 1.1), Cell("drawer", 1.2)]
    cases.unit(kit, own, columns, widths, cap=0.022)


@design("display_cabinet", "modern", "scandi", "shaker", "industrial", "classic")
def display_cabinet(kit: Kit) -> None:
    """Glazed doors over solid ones."""
    own = look(kit.style, kit.taste())
    columns = cases.door_columns(kit, kit.w)
    for column in columns:
        kind = column[0].kind
        column[:] = [Cell(f"glass_{kind}", 1.0, 3), Cell(kind, 0.42, 1)]
    cases.unit(kit, own, columns, cases.door_widths(kit, kit.w), cap=0.04 if own.overhang else 0.02)


@design("filing_cabinet", "steel", "modern", "wood")
def filing_cabinet(kit: Kit) -> None:
    """Deep equal drawers for hanging files."""
    own = {
        "steel": Look(kit.pick("graphite", "greige", "white"), "", "", "aluminium", "slab", "cup", "plinth", "black"),
        "modern": Look("white", "white", "white", "aluminium", "slab", "edge", "plinth", "graphite"),
        "wood": Look("oak", "oak", "oak", "black_metal", "slab", "bar", "plinth", "black"),
    }[kit.style]
    own = own if own.front else own.with_(front=own.body, top=own.body)
    cells = [Cell("drawer") for _ in range(max(2, round(kit.h / 0.33)))]
    cases.unit(kit, own, [cells] if kit.w < 0.7 else [cells, cells])


@design("shoe_cabinet", "modern", "scandi", "shaker", "industrial")
def shoe_cabinet(kit: Kit) -> None:
    """Rows of tilting flaps, each with a narrow tray behind it."""
    own = look(kit.style, kit.taste())
    own = own.with_(base="plinth" if own.base == "plinth" else "taper", overhang=0.0)
    foot, cap = min(cases.base_height(own, kit.h), 0.1), 0.02
    front, z = kit.x[1], (foot, kit.h - cap)
    out = fronts.projection(own)
    edge = front - out - fronts.LEAF - 0.002
    cases.stand(kit, own, (kit.x[0], front - out), kit.y, foot)
    inner_y, _, back = cases.carcass(kit, own, (kit.x[0], edge), kit.y, z)
    rows = max(3, -int(-(z[1] - z[0]) // 0.36))
    tall = (z[1] - z[0]) / rows
    upto = 0.85
    for i in range(rows):
        low = z[0] + i * tall
        body = fronts.flap(kit, own, front, kit.y, (low, low + tall), upto=upto, bar=0.2)
        _shoe_tray(kit, body, edge, back, inner_y, low, tall, front)
    cases.crown(kit, own, (kit.h - cap, kit.h))


def _shoe_tray(
    kit: Kit, body: Body, edge: float, back: float, y: tuple[float, float], low: float, tall: float, front: float
) -> None:
    # The tray's far upper corner turns about the hinge; it must pass under the board or flap above.
    least, clear = 0.06, tall - 0.03
    deep = min(edge - back - 0.02, 0.55 * tall, 0.16, max(clear**2 - least**2, 0.0) ** 0.5 - (front - edge))
    if deep < 0.03:
        return
    base = low + 0.024
    top = min(tall * 0.55, (clear**2 - (front - edge + deep) ** 2) ** 0.5)
    x, own = (edge - deep, edge + 0.002), (y[0] + 0.006, y[1] - 0.006)
    body.box("drawer_board", x, own, (base, base + 0.008))
    body.box("drawer_board", (x[0], x[0] + 0.008), own, (base + 0.008, low + top))


@design("tv_stand", *CASE_STYLES)
def tv_stand(kit: Kit) -> None:
    """A low unit: open bay for devices between doors, or drawers beside it."""
    own = look(kit.style, kit.taste())
    columns, widths = cases.door_columns(kit, kit.w), cases.door_widths(kit, kit.w)
    if len(columns) > 1:
        columns[len(columns) // 2] = [Cell("open", 1.0, 1)]
    if len(columns) > 2:
        columns[0] = [Cell("drawer"), Cell("drawer")] if kit.h > 0.48 else [Cell("drawer")]
    cases.unit(kit, own, columns, widths)
