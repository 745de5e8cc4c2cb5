"""Groups of a drawing: artists named LAYER/THING become `<g id="LAYER">` with a `<g id="THING">` for each thing."""

import re
from collections import Counter
from xml.etree import ElementTree

SVG, LINK = "http://www.w3.org/2000/svg", "http://www.w3.org/1999/xlink"
GROUP = f"{{{SVG}}}g"


def grouped(text: str) -> str:
    """The SVG text with what is named alike and drawn one after another in one group."""
    ElementTree.register_namespace("", SVG)
    ElementTree.register_namespace("xlink", LINK)
    root = ElementTree.fromstring(text)
    taken: Counter[str] = Counter()
    for parent in [one for one in root.iter(GROUP) if any("/" in child.get("id", "") for child in one)]:
        _regroup(parent, taken)
    return '<?xml version="1.0" encoding="utf-8" standalone="no"?>\n' + ElementTree.tostring(root, encoding="unicode")


def _regroup(parent: ElementTree.Element, taken: Counter[str]) -> None:
    layer: ElementTree.Element | None = None
    thing: ElementTree.Element | None = None
    now: tuple[str, str] = ("", "")
    for child in list(parent):
        parent.remove(child)
        first, slash, second = child.get("id", "").partition("/")
        if not slash:
            layer, now = None, ("", "")
            parent.append(child)
            continue
        if layer is None or first != now[0]:
            layer, thing = _new(parent, first, taken), None
        if thing is None or second != now[1]:
            thing = _new(layer, second, taken)
        now = (first, second)
        del child.attrib["id"]
        thing.append(child)


def _new(parent: ElementTree.Element, name: str, taken: Counter[str]) -> ElementTree.Element:
    """A group of that name, numbered where it is taken."""
    plain = re.sub(r"[^\w.-]", "_", name)
    plain = plain if re.match(r"[A-Za-z_]", plain) else f"_{plain}"
    taken[plain] += 1
    return ElementTree.SubElement(parent, GROUP, {"id": plain if taken[plain] == 1 else f"{plain}-{taken[plain]}"})
