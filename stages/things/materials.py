"""The palette of surfaces: physically based materials, their densities, and seeded procedural textures.

A textured material's image carries its colour; `Material.color` is the image's mean, for renderers without
textures, and must not be multiplied with it. Texture coordinates of the embedded library count repeats:
one repeat of a pattern covers `span(name)` metres. Wood grain runs along the image's x axis (u).
"""

import zlib
from functools import cache

import numpy as np
from numpy.typing import NDArray

from apartgen.schemas.errors import BadInput, near
from apartgen.stages.things.asset import Material
from apartgen.stages.things.laid import LAID
from apartgen.stages.things.patterns import PATTERNS
from apartgen.stages.things.prints import PRINTS, SHEETS

Image = NDArray[np.uint8]

# name: (red, green, blue), roughness, metalness, pattern, density kg/m³
_TABLE: dict[str, tuple[tuple[int, int, int], float, float, str, float]] = {
    "oak": ((188, 146, 98), 0.55, 0, "wood", 700), "light_oak": ((214, 182, 138), 0.6, 0, "wood", 680),
    "walnut": ((104, 70, 48), 0.5, 0, "wood", 640), "birch": ((226, 200, 160), 0.55, 0, "wood", 620),
    "pine": ((222, 178, 118), 0.6, 0, "wood", 520), "cherry": ((142, 74, 46), 0.4, 0, "wood", 600),
    "dark_oak": ((84, 62, 46), 0.55, 0, "wood", 720), "ash_black": ((48, 44, 42), 0.5, 0, "wood", 680),
    "teak": ((158, 106, 64), 0.55, 0, "wood", 650), "bamboo": ((204, 170, 110), 0.5, 0, "wood", 600),
    "chipboard": ((206, 198, 184), 0.7, 0, "", 680), "drawer_board": ((222, 214, 198), 0.7, 0, "", 650),
    "white": ((240, 239, 235), 0.45, 0, "", 740), "cream": ((232, 223, 203), 0.5, 0, "", 740),
    "sage": ((150, 166, 146), 0.5, 0, "", 740), "navy": ((46, 62, 88), 0.45, 0, "", 740),
    "graphite": ((74, 77, 80), 0.5, 0, "", 740), "black": ((34, 34, 36), 0.5, 0, "", 740),
    "greige": ((188, 178, 164), 0.5, 0, "", 740), "blush": ((214, 176, 164), 0.5, 0, "", 740),
    "dusk_blue": ((134, 154, 172), 0.5, 0, "", 740), "mint": ((178, 208, 192), 0.5, 0, "", 740),
    "yellow": ((226, 186, 84), 0.5, 0, "", 740),
    "steel": ((190, 192, 194), 0.35, 1, "brushed", 7800), "chrome": ((214, 216, 220), 0.12, 1, "", 7800),
    "aluminium": ((176, 178, 180), 0.45, 1, "brushed", 2700), "brass": ((196, 160, 92), 0.3, 1, "", 8400),
    "copper": ((190, 120, 88), 0.3, 1, "", 8900), "black_metal": ((38, 39, 41), 0.5, 0.6, "", 7800),
    "white_metal": ((232, 232, 230), 0.4, 0.2, "", 7800), "enamel": ((238, 239, 240), 0.25, 0, "", 2600),
    "linen": ((206, 196, 178), 0.95, 0, "weave", 60), "grey_fabric": ((138, 140, 142), 0.95, 0, "weave", 60),
    "charcoal_fabric": ((70, 72, 76), 0.95, 0, "weave", 60), "blue_fabric": ((78, 104, 132), 0.95, 0, "weave", 60),
    "rust_fabric": ((176, 92, 58), 0.95, 0, "weave", 60), "mustard_fabric": ((202, 156, 66), 0.95, 0, "weave", 60),
    "sage_fabric": ((134, 148, 122), 0.95, 0, "weave", 60), "cream_boucle": ((230, 224, 210), 1.0, 0, "boucle", 60),
    "green_velvet": ((48, 88, 72), 0.8, 0, "velvet", 60), "blue_velvet": ((44, 60, 104), 0.8, 0, "velvet", 60),
    "rose_velvet": ((184, 128, 126), 0.8, 0, "velvet", 60), "plum_velvet": ((96, 56, 80), 0.8, 0, "velvet", 60),
    "tan_leather": ((160, 104, 62), 0.45, 0, "leather", 90), "brown_leather": ((92, 58, 40), 0.45, 0, "leather", 90),
    "black_leather": ((44, 42, 42), 0.4, 0, "leather", 90), "mesh_black": ((52, 54, 58), 0.9, 0, "cane", 200),
    "mattress": ((238, 236, 230), 0.95, 0, "quilt", 45), "bedding": ((240, 238, 234), 0.95, 0, "weave", 35),
    "duvet_blue": ((122, 142, 164), 0.95, 0, "weave", 35), "duvet_sand": ((212, 196, 170), 0.95, 0, "weave", 35),
    "duvet_green": ((142, 156, 132), 0.95, 0, "weave", 35), "duvet_rose": ((206, 168, 158), 0.95, 0, "weave", 35),
    "duvet_grey": ((164, 166, 170), 0.95, 0, "weave", 35), "sheer": ((236, 234, 228), 0.95, 0, "weave", 250),
    "towel": ((214, 222, 222), 1.0, 0, "boucle", 200), "paper_shade": ((242, 234, 214), 0.9, 0, "", 400),
    "rug_kilim": ((176, 120, 92), 1.0, 0, "kilim", 250), "rug_plain": ((206, 198, 186), 1.0, 0, "boucle", 250),
    "rug_border": ((120, 62, 56), 1.0, 0, "persian", 250), "rug_stripe": ((196, 188, 172), 1.0, 0, "stripe", 250),
    "rug_berber": ((226, 220, 206), 1.0, 0, "berber", 250), "rug_blue": ((98, 118, 140), 1.0, 0, "persian", 250),
    "jute": ((188, 158, 112), 1.0, 0, "wicker", 250), "fringe": ((222, 212, 192), 1.0, 0, "", 150),
    "marble": ((232, 230, 226), 0.2, 0, "marble", 2700), "dark_marble": ((58, 60, 62), 0.2, 0, "marble", 2700),
    "granite": ((96, 94, 92), 0.3, 0, "speckle", 2700), "terrazzo": ((218, 212, 202), 0.35, 0, "terrazzo", 2300),
    "concrete": ((160, 158, 154), 0.8, 0, "cloud", 2300), "worktop_white": ((228, 226, 220), 0.35, 0, "speckle", 1700),
    "tile_white": ((230, 232, 232), 0.25, 0, "tile", 2300), "floor_tile": ((190, 186, 178), 0.35, 0, "tile", 2300),
    "floor_oak": ((196, 156, 110), 0.5, 0, "planks", 700), "plaster": ((240, 237, 230), 0.9, 0, "", 1200),
    "carpet": ((178, 170, 158), 1.0, 0, "boucle", 250), "decking": ((146, 110, 78), 0.7, 0, "planks", 700),
    "porcelain": ((244, 244, 242), 0.12, 0, "", 2400), "acrylic": ((245, 245, 244), 0.15, 0, "", 1200),
    "glass": ((206, 226, 228), 0.05, 0, "", 2500), "smoked_glass": ((60, 64, 68), 0.08, 0, "", 2500),
    "mirror": ((226, 232, 234), 0.03, 1, "", 2500), "screen": ((18, 19, 22), 0.15, 0, "", 1500),
    "black_glass": ((24, 25, 28), 0.08, 0, "", 2500), "plastic_white": ((236, 236, 234), 0.4, 0, "", 950),
    "plastic_black": ((40, 41, 44), 0.5, 0, "", 950), "plastic_grey": ((128, 131, 134), 0.5, 0, "", 950),
    "rubber": ((46, 46, 48), 0.9, 0, "", 1100), "bulb": ((255, 244, 214), 0.3, 0, "", 400),
    "leaf": ((70, 118, 58), 0.6, 0, "", 500), "leaf_dark": ((44, 88, 50), 0.5, 0, "", 500),
    "leaf_light": ((124, 158, 84), 0.6, 0, "", 500), "leaf_grey": ((124, 142, 112), 0.7, 0, "", 500),
    "flower_red": ((198, 62, 68), 0.7, 0, "", 300), "flower_pink": ((224, 142, 168), 0.7, 0, "", 300),
    "flower_yellow": ((236, 196, 72), 0.7, 0, "", 300), "bark": ((112, 84, 60), 0.9, 0, "wood", 600),
    "soil": ((66, 50, 38), 1.0, 0, "cloud", 1200), "terracotta": ((184, 106, 74), 0.85, 0, "cloud", 1900),
    "rattan": ((196, 156, 104), 0.8, 0, "wicker", 350), "wicker_dark": ((110, 84, 60), 0.85, 0, "wicker", 350),
    "cane": ((214, 182, 132), 0.8, 0, "cane", 350), "felt": ((120, 122, 124), 1.0, 0, "boucle", 200),
    "apple_red": ((176, 42, 38), 0.35, 0, "", 850), "apple_green": ((142, 172, 62), 0.35, 0, "", 850),
    "orange_peel": ((236, 142, 42), 0.6, 0, "", 850), "banana_peel": ((238, 208, 82), 0.6, 0, "", 900),
    "crust": ((184, 126, 70), 0.9, 0, "cloud", 300), "paper": ((236, 232, 222), 0.9, 0, "", 800),
    "cardboard": ((190, 154, 110), 0.9, 0, "", 200), "amber_glass": ((120, 66, 24), 0.08, 0, "", 2500),
    "green_glass": ((44, 84, 50), 0.08, 0, "", 2500), "red": ((190, 50, 48), 0.5, 0, "", 950),
    "sky": ((96, 152, 200), 0.5, 0, "", 950), "lime": ((126, 170, 80), 0.5, 0, "", 950),
    "wax": ((240, 228, 204), 0.6, 0, "", 900), "skin_soap": ((236, 214, 190), 0.4, 0, "", 1000),
    "floor_light_oak": ((216, 188, 148), 0.5, 0, "planks", 680),
    "floor_walnut": ((116, 82, 58), 0.45, 0, "planks", 640),
    "floor_grey_oak": ((168, 158, 146), 0.55, 0, "planks", 700),
    "floor_pine": ((220, 180, 124), 0.55, 0, "planks", 520),
    "herringbone_oak": ((190, 150, 104), 0.45, 0, "herringbone", 700),
    "herringbone_smoked": ((122, 90, 66), 0.45, 0, "herringbone", 700),
    "carpet_grey": ((142, 144, 148), 1.0, 0, "boucle", 250), "cork": ((184, 142, 98), 0.8, 0, "speckle", 450),
    "floor_slate": ((92, 96, 98), 0.5, 0, "tile", 2700), "floor_terracotta": ((182, 114, 82), 0.7, 0, "tile", 2000),
    "floor_hexagons": ((206, 204, 198), 0.4, 0, "hexagons", 2300),
    "floor_chequers": ((150, 148, 144), 0.35, 0, "chequers", 2300),
    "wall_white": ((240, 239, 235), 0.9, 0, "", 1200), "wall_sand": ((229, 219, 199), 0.9, 0, "", 1200),
    "wall_mist": ((214, 224, 224), 0.9, 0, "", 1200), "wall_sage": ((186, 198, 176), 0.9, 0, "", 1200),
    "wall_blush": ((232, 212, 202), 0.9, 0, "", 1200), "wall_clay": ((206, 172, 148), 0.9, 0, "", 1200),
    "wall_grey": ((204, 205, 204), 0.9, 0, "", 1200), "wall_blue": ((148, 168, 186), 0.9, 0, "", 1200),
    "wall_ochre": ((218, 190, 130), 0.9, 0, "", 1200), "wall_olive": ((150, 152, 118), 0.9, 0, "", 1200),
    "wall_greige": ((214, 206, 194), 0.9, 0, "", 1200), "limewash": ((224, 216, 204), 0.95, 0, "lime", 1200),
    "brick_white": ((222, 218, 210), 0.9, 0, "bricks", 1800), "brick_red": ((172, 108, 86), 0.95, 0, "bricks", 1800),
    "paper_stripes": ((222, 216, 202), 0.85, 0, "striped_paper", 1200),
    "paper_leaves": ((206, 214, 198), 0.85, 0, "leaves", 1200),
    "metro_white": ((234, 235, 234), 0.2, 0, "metro", 2300), "metro_green": ((110, 142, 122), 0.2, 0, "metro", 2300),
    "tile_sand": ((216, 204, 184), 0.3, 0, "tile", 2300), "tile_blue": ((150, 176, 190), 0.25, 0, "tile", 2300),
    "keys_white": ((244, 243, 238), 0.3, 0, "", 1000), "piano_black": ((22, 22, 24), 0.1, 0, "", 740),
}  # fmt: skip
_TABLE |= {name: (color, 0.7, 0, pattern, 950) for name, (pattern, color) in SHEETS.items()}

_ALPHA = {"glass": 0.28, "smoked_glass": 0.6, "sheer": 0.85}
_EMISSION = {"bulb": 1.0, "paper_shade": 0.35}
_SPAN = {
    "wood": 1.2, "weave": 0.16, "boucle": 0.3, "velvet": 0.6, "leather": 0.3, "quilt": 0.25, "kilim": 0.8,
    "persian": 0.7, "stripe": 0.5, "berber": 0.6, "wicker": 0.12, "marble": 1.2, "speckle": 0.5, "terrazzo": 0.6,
    "cloud": 0.8, "tile": 0.6, "planks": 1.6, "brushed": 0.4, "cane": 0.08, "herringbone": 0.72, "hexagons": 0.7,
    "chequers": 0.6, "metro": 0.4, "bricks": 0.52, "striped_paper": 0.5, "leaves": 0.64, "lime": 1.2,
}  # fmt: skip


def _material(name: str) -> Material:
    (r, g, b), roughness, metalness, pattern, _ = _TABLE[name]
    color = (r / 255, g / 255, b / 255, _ALPHA.get(name, 1.0))
    return Material(name, color, roughness, float(metalness), name if pattern else None, _EMISSION.get(name, 0.0))


PALETTE: dict[str, Material] = {name: _material(name) for name in _TABLE}


def material(name: str) -> Material:
    """The material of that name; BadInput where there is none."""
    if name not in PALETTE:
        raise BadInput(f"no material {name!r}; {near(name, PALETTE)}")
    return PALETTE[name]


def density(name: str) -> float:
    """kg/m³ of the solid material, BadInput where there is none; upholstery and foliage as foam and air allow."""
    return _TABLE[material(name).name][4]


def span(name: str) -> float:
    """Metres that one repeat of the material's texture covers; 1 for plain ones."""
    return repeat(_TABLE[name][3])


def repeat(pattern: str) -> float:
    """Metres that one repeat of a pattern covers."""
    return _SPAN.get(pattern, 1.0)


def shades(pattern: str, size: int) -> NDArray[np.float64]:
    """How light a pattern is on a grey ground, (size, size)."""
    rng = np.random.default_rng(zlib.crc32(pattern.encode()))
    return np.asarray((PATTERNS | LAID | PRINTS)[pattern](rng, size, np.full(3, 128.0)).mean(2))


def pattern(name: str) -> str:
    """Name of the pattern that the material's texture is drawn by, empty for plain ones."""
    return _TABLE[name][3]


def textures() -> tuple[str, ...]:
    """Names that `texture` draws."""
    return tuple(name for name, row in _TABLE.items() if row[3])


@cache
def texture(name: str, size: int = 256) -> Image:
    """The tileable colour image (size, size, 3) of a textured material; the same bytes every time."""
    if name not in _TABLE or not _TABLE[name][3]:
        raise BadInput(f"no procedural texture {name!r}; one of {', '.join(textures())}")
    color, _, _, pattern, _ = _TABLE[name]
    rng = np.random.default_rng(zlib.crc32(name.encode()))
    shade = (PATTERNS | LAID | PRINTS)[pattern](rng, size, np.array(color, float))
    whole = np.rint(shade)
    image = np.clip(whole, 0, 255, out=whole).astype(np.uint8)
    image.flags.writeable = False
    return image
