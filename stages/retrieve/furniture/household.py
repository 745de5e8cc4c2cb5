"""Bins, laundry baskets, ironing boards."""

import numpy as np

from apartgen.stages.retrieve.furniture.bath import ring
from apartgen.stages.retrieve.furniture.body import Body
from apartgen.stages.retrieve.furniture.designs import design
from apartgen.stages.retrieve.furniture.kit import Kit
from apartgen.stages.retrieve.furniture.tables import ellipse
from apartgen.stages.things import materials


def _lidded(kit: Kit, body: str, lid: str, exponent: float, foot: float, thick: float, wall: float) -> None:
    """An open vessel whose lid turns about its rear edge, within the vessel's wall.

    Upright, such a lid keeps off the wall that a light vessel is pushed against while it is opened.
    """
    b, rim, n = kit.base, kit.h - thick - 0.002, 32
    half, start = (kit.d / 2, kit.w / 2), 0.015
    outer = [ring((0, 0), (half[0] * s, half[1] * s), z, exponent, n) for s, z in ((foot, 0), (1.0, rim))]
    inner = [
        ring((0, 0), (half[0] * s - wall, half[1] * s - wall), z, exponent, n) for s, z in ((1.0, rim), (foot, start))
    ]
    b.hollow(body, np.array(outer), np.array(inner))
    cover = Body()
    cover.fill = 500 / materials.density(lid)
    z = (rim + 0.002, kit.h)
    # Turning up, a thick lid's lower front edge first moves forward a little.
    short = thick**2 / (2 * kit.d) + 0.001
    middle, deep = (wall - short) / 2, half[0] - (wall + short) / 2
    cover.prism(lid, ring((middle, 0), (deep, half[1]), 0, exponent, n)[:, :2], *z, smooth=True)
    kit.hinge("lid", cover, (kit.x[0] + wall, 0, z[1]), (0, -1, 0), handle=(kit.x[1] - short, 0, z[0]))


@design("bin", "pedal", "square", "swing")
def bin_(kit: Kit) -> None:
    """A bin with a lid."""
    material, lid = {
        "pedal": (kit.pick("steel", "white", "black"), "plastic_black"),
        "square": (kit.pick("graphite", "white"), "plastic_grey"),
        "swing": (kit.pick("mint", "cream", "plastic_grey"), "steel"),
    }[kit.style]
    kit.base.fill = 0.25
    _lidded(
        kit, material, lid, 5.0 if kit.style == "square" else 2.0, 0.8 if kit.style == "swing" else 0.97, 0.035, 0.008
    )
    kit.base.fill = 1.0


@design("laundry_basket", "wicker", "linen", "plastic")
def laundry_basket(kit: Kit) -> None:
    """A hamper with a lid."""
    body, lid = {
        "wicker": (w := kit.pick("rattan", "wicker_dark"), w),
        "linen": ("linen", "oak"),
        "plastic": ("plastic_white", "plastic_grey"),
    }[kit.style]
    _lidded(kit, body, lid, 3.5 if kit.style != "wicker" else 2.6, 0.86, 0.022, 0.012)


@design("ironing_board", "classic", "compact")
def ironing_board(kit: Kit) -> None:
    """A padded board, pointed at one end, on crossed legs."""
    b, h = kit.base, kit.h
    cover = kit.pick("blue_fabric", "grey_fabric", "sage_fabric")
    n = 32
    c = ellipse(kit, 1.0, n, 3.5)
    nose = np.clip((c[:, 1] / kit.w + 0.5 - 0.62) / 0.38, 0, 1)
    c[:, 0] *= 1 - 0.75 * nose**1.5
    b.prism(cover, c, h - 0.035, h, smooth=True)
    b.box("white_metal", (-0.03, 0.03), (-0.4 * kit.w, 0.3 * kit.w), (h - 0.05, h - 0.035))
    s = kit.d / 2 - 0.02
    for x, sign in ((-0.05, 1), (0.05, -1)):
        y = 0.32 * kit.w
        b.rod("white_metal", (x, -sign * y, 0.014), (x, sign * y * 0.8, h - 0.05), 0.011, n=10)
        b.rod("white_metal", (-s, -sign * y, 0.012), (s, -sign * y, 0.012), 0.012, n=10)
    if kit.style == "classic":
        b.tube("steel", [(0, kit.y[0] + 0.004, h - 0.03), (0, kit.y[0] + 0.05, h - 0.045)], 0.004, 6)
