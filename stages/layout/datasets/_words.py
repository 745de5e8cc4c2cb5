"""What a thing is, from a description or a foreign category name: our category, or None for what we do not have."""

import re
from functools import cache

from apartgen.schemas.base import RoomType
from apartgen.stages.things.categories import by_word

PATTERNS: tuple[tuple[str, str | None], ...] = (
    (r"slipper|shoes\b|sneaker|heels\b|vase\b|pillows? (and|with)|air condition|purifier|sculpture|ornament", None),
    (r"sideboard / side", "sideboard"), (r"lounge chair / cafe|lazy sofa", "armchair"), (r"bookcase /", "bookshelf"),
    (r"foot ?stool|sofastool|ottoman|pouf|hassock", "pouffe"), (r"coffee table|cocktail table", "coffee_table"),
    (r"console table|entryway table", "console_table"),
    (r"side table|end table|corner table|round end table|accent table", "side_table"),
    (r"dressing table|vanity table|makeup", "dressing_table"), (r"nightstand|night stand|bedside", "nightstand"),
    (r"dining set|dining table|bar table|\bbar cart", "dining_table"), (r"desk lamp|table lamp", "table_lamp"),
    (r"floor lamp|standing lamp", "floor_lamp"), (r"wall (lamp|sconce|light)|sconce", "wall_lamp"),
    (r"pendant|chandelier|ceiling|hanging lamp|hanging light|suspension lamp", "ceiling_lamp"),
    (r"tv stand|tv console|media (console|unit|cabinet)|television stand|tv cabinet|tv unit", "tv_stand"),
    (r"television|\btv\b", "tv"), (r"bunk bed|loft bed", "bunk_bed"), (r"crib|baby bed|cradle", "cot"),
    (r"single bed|twin bed|kids'? bed|children'?s bed|daybed", "single_bed"),
    (r"l.shaped.*sofa|sectional|corner sofa|chaise", "corner_sofa"), (r"sofa bed|loveseat|couch", "sofa"),
    (r"\bsofa\b", "sofa"),
    (r"bar ?stool|\bstool\b", "stool"),
    (r"office chair|swivel chair|desk chair|gaming chair|task chair", "office_chair"),
    (r"arm ?chair|lounge chair|recliner|rocking chair|accent chair|wingback|lazy|bean bag", "armchair"),
    (r"chair\b", "chair"), (r"headboard|\bbed\b|bed frame", "double_bed"), (r"wardrobe|armoire|closet", "wardrobe"),
    (r"bookcase|book ?shel|shelving|display shel|bookrack", "bookshelf"),
    (r"wine cabinet|display cabinet|china cabinet|vitrine|wine cooler", "display_cabinet"),
    (r"shoe cabinet|shoe rack", "shoe_cabinet"), (r"sideboard|buffet|credenza", "sideboard"),
    (r"chest of drawers|dresser|drawer chest|chest|drawer", "chest"), (r"\bdesk\b|writing table", "desk"),
    (r"bench\b", "bench"), (r"plant|potted|\bpot\b|palm|planter|tree\b", "plant"), (r"refrigerator|fridge", "fridge"),
    (r"piano", "piano"), (r"washing machine", "washing_machine"),
    (r"coat (rack|stand)|hanger|clothes rack", "coat_rack"),
    (r"cabinet", "sideboard"), (r"shelf|shelves", "wall_shelf"), (r"curtain|drape", "curtain"), (r"mirror", "mirror"),
    (r"rug|carpet", "rug"), (r"table\b", "dining_table"), (r"lamp|light", "ceiling_lamp"),
)
"""Tried in order on the lower-case text; None stands for things that are no furniture."""

ROOMS: dict[str, RoomType] = {
    "livingroom": "living_room", "livingdiningroom": "living_room", "lounge": "living_room",
    "diningroom": "dining_room",
    "bedroom": "bedroom", "masterbedroom": "bedroom", "secondbedroom": "bedroom", "kidsroom": "bedroom",
    "elderlyroom": "bedroom", "nannyroom": "bedroom", "kitchen": "kitchen", "bathroom": "bathroom",
    "masterbathroom": "bathroom", "secondbathroom": "bathroom", "library": "study", "study": "study",
    "hallway": "hallway", "corridor": "hallway", "aisle": "hallway", "cloakroom": "closet", "storageroom": "storage",
    "equipmentroom": "utility", "laundryroom": "utility", "balcony": "balcony", "terrace": "balcony",
}
"""Room names of other data sets, lower case without blanks."""


@cache
def category(text: str) -> str | None:
    """Our category for an English description such as "grey loveseat sofa with wooden legs"."""
    words = text.lower().replace("_", " ").strip()
    if words in by_word():
        return by_word()[words]
    # What comes after "with" and its like tells of details, not of the thing.
    head = re.split(r",? with |,? featuring |,? showcasing |, ", words)[0]
    for part in (head, words):
        for pattern, name in PATTERNS:
            if re.search(pattern, part):
                return name
    return None


def by_size(name: str, size: tuple[float, float, float]) -> str:
    """The category once the size [depth, width, height] is known: narrow beds are single, deep sofas angular."""
    if name in ("double_bed", "single_bed"):
        return "single_bed" if size[1] < 1.35 else "double_bed"
    if name in ("sofa", "corner_sofa"):
        return "corner_sofa" if size[0] > 1.35 else "sofa"
    if name == "dining_table" and max(size[:2]) < 0.7:
        return "side_table"
    if name == "dining_table" and abs(size[0] - size[1]) < 0.05:
        return "round_table"
    return name


def room_type(text: str) -> RoomType | None:
    """Our room type for another data set's name, or None."""
    return ROOMS.get(re.sub(r"[^a-z]", "", text.lower()))
