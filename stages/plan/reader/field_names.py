"""Names that programs give to fields, by what is meant."""

NAME = ("room", "type", "kind", "name", "id", "label", "room type", "room name")
COUNT = ("count", "number", "qty", "quantity", "n", "num", "amount", "how many")
IGNORED = ("version", "schema", "format", "seed", "currency", "units", "language", "country", "city", "title", "id")
USUAL = ("living room", "kitchen", "hallway", "hall", "living", "corridor")
"""Rooms that a home has though nobody counts them."""
HOME = ("home", "flat", "apartment", "house", "unit", "dwelling", "total", "overall", "plan", "whole", "property")
WRAP = ("rooms", "other rooms", "additional rooms", "room types", "layout", "floor plan", "floorplan", "program",
        "programme", "spaces", "room list", "spec", "request", "apartment spec", "design", "brief")  # fmt: skip
TEXT = ("constraints", "requirements", "preferences", "notes", "note", "wishes", "rules", "description", "prompt",
        "text", "extras", "comment", "comments", "other", "must have", "must haves", "residents", "occupants",
        "household", "people", "avoid", "task", "action", "goal")  # fmt: skip
THINGS = ("furniture", "objects", "contents", "items", "furnishings", "fixtures", "equipment", "things", "contains",
          "has", "appliances", "with", "needs")  # fmt: skip
DIRECTION = {"facing": True, "faces": True, "face": True, "orientation": True, "aspect": True, "exposure": True,
             "windows": True, "window": True, "view": True, "oriented": True, "windows to": True, "light": True,
             "position": False, "location": False, "side": False, "placement": False, "place": False, "where": False,
             "zone": False, "at": False, "in": False, "on": False, "located": False}  # fmt: skip
"""Whether a key is of what windows look to or of where a room lies."""
OF_BEDROOMS = ("walk in closet", "closet", "dressing room", "balcony", "ensuite bathroom", "en suite bathroom")
"""Rooms that belong to a bedroom."""
SIZE = ("size", "scale")
OPEN = ("open plan", "open kitchen", "open concept", "open space", "open", "open links", "open connections",
        "open passages", "openings", "open between", "open edges")  # fmt: skip
NOTES = ("notes", "note", "remarks", "remark", "features", "feature", "wishes", "requirements", "details", "comment",
         "comments", "extras", "special")  # fmt: skip
"""Fields of a room that say anything of it, piece by piece."""
AMOUNT = {"area": "", "size": "", "total area": "", "floor area": "", "surface": "", "total": "",
          "total floor area": "",
          "areas": "", "sizes": "", "room areas": "", "room sizes": "", "floor areas": "", "area by room": "",
          "total size": "", "footprint": "", "net area": "", "gross area": "", "width": "width",
          "length": "length", "doors": "doors", "door count": "doors", "number of doors": "doors",
          "dimensions": "dimension",
          "dimension": "dimension", "dims": "dimension", "measures": "dimension"}  # fmt: skip
"""What a key measures; an area's is empty."""
LIMIT = {"min": "at least", "minimum": "at least", "max": "at most", "maximum": "at most", "at least": "at least",
         "at most": "at most", "least": "at least", "most": "at most", "gte": "at least", "lte": "at most"}  # fmt: skip
UNIT = r"m2|m\^2|m²|sqm|sq m|square meters|square metres|sqft|sq ft|ft2|square feet"
_VERBS = {
    "is next to": ("next to", "adjacent to", "adjacent", "beside", "adjoining", "adjoins", "adjacency", "neighbours",
                   "neighbors", "neighbour", "neighbor", "shares wall with", "bordering", "must be adjacent"),
    "is near": ("near", "close to", "near to", "close", "proximity", "nearby"),
    "is far from": ("far from", "away from", "apart from", "distant from", "apart", "far", "not near", "well away from",
                    "keep away from", "as far as possible from", "far apart", "apart from each other", "distance"),
    "is opposite": ("opposite", "opposite to", "across from", "facing room", "vis a vis"),
    "is open to": ("open to", "open plan with", "open with"),
    "has a door to": ("door to", "doors to", "connects to", "connected to", "connections", "connected", "access from",
                      "accessed from", "access", "accessible from", "entered from", "entrance from", "off", "door",
                      "leads to", "opens to", "opens off", "opens from", "opens onto", "entry from", "access via",
                      "reached from",
                      "enter from", "linked to", "connection", "connects", "doors between", "door between"),
    "no door": ("no door", "no door to", "no doors", "no doors to", "not connected to", "no direct access to",
                "no door between", "no connection", "no access to", "disconnected"),
    "is not next to": ("not next to", "not adjacent to", "not adjacent", "not beside"),
    "is larger than": ("larger than", "bigger than", "larger", "bigger"),
    "is smaller than": ("smaller than", "smaller"),
}  # fmt: skip
RELATIONS = {name: verb for verb, names in _VERBS.items() for name in names}
"""What is said between two rooms, by the name of its field."""
