"""XML of robot description formats: numbers, elements, indented text."""

from collections.abc import Iterable
from pathlib import Path
from xml.etree import ElementTree

import numpy as np

Element = ElementTree.Element
SCALE = 1e-9
"""Smaller numbers are rounding of zero."""


def number(value: float) -> str:
    """Shortest text to nine digits, without a negative zero."""
    return f"{0.0 if abs(value) < SCALE else float(value):.9g}"


def numbers(values: Iterable[float]) -> str:
    """Numbers with blanks between them."""
    plain = [0.0 if -SCALE < v < SCALE else v for v in (values.tolist() if isinstance(values, np.ndarray) else values)]
    return " ".join(["%.9g"] * len(plain)) % tuple(plain)


def add(parent: Element, tag: str, text: str | None = None, **attributes: str | float | Iterable[float]) -> Element:
    """A child element; numbers and vectors are written as text, a trailing underscore of a name is dropped."""
    child = ElementTree.SubElement(parent, tag)
    child.text = text
    for name, value in attributes.items():
        if not isinstance(value, str):
            value = number(value) if isinstance(value, int | float) else numbers(value)
        child.set(name.rstrip("_"), value)
    return child


def save(root: Element, path: Path) -> Path:
    """Write the document, indented by two."""
    ElementTree.indent(root)
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text('<?xml version="1.0" encoding="utf-8"?>\n' + ElementTree.tostring(root, "unicode") + "\n", "utf-8")
    return path
