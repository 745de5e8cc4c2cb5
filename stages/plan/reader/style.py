"""What words of style do to weights, regularity and areas."""

from typing import Any

from apartgen.stages.plan.reader.sense import sense
from apartgen.stages.plan.reader.statements import Said


def style_of(said: Said) -> dict[str, Any]:
    """`weights` by term, `regularity`, and the factors `scale` of all areas and `hallway` of hallways."""
    out: dict[str, Any] = {"weights": {}, "regularity": 0.7, "scale": 1.0, "hallway": 1.0}
    for name in dict.fromkeys(said.styles):
        style = sense()["style"][name]
        for term, factor in style["weights"].items():
            out["weights"][term] = round(out["weights"].get(term, 1.0) * factor, 4)
        out["regularity"] = style.get("regularity", out["regularity"])
        out["scale"] *= style.get("scale", 1.0)
        out["hallway"] *= style.get("hallway", 1.0)
    return out
