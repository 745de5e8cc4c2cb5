"""XML of robot description formats: numbers, elements, indented text."""

import re
from collections.abc import Iterable
from functools import cache
from html import escape
from pathlib import Path
from xml.etree import ElementTree

import numpy as np

Element = ElementTree.Element
SCALE = 1e-9
"""Smaller numbers are rounding of zero."""
ENTITIES = {"&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;", "\r": "&#13;", "\n": "&#10;", "\t": "&#09;"}
SPECIAL = re.compile("[&<>\r\n\t]")
"""What is written otherwise, but for what ends an attribute."""


def number(value: float) -> str:
    """Shortest text to nine digits, without a negative zero."""
    return f"{0.0 if abs(value) < SCALE else float(value):.9g}"


def numbers(values: Iterable[float]) -> str:
    """Numbers with blanks between them."""
    plain = [0.0 if -SCALE < v < SCALE else v for v in (values.tolist() if isinstance(values, np.ndarray) else values)]
    return _blanks(len(plain)) % tuple(plain)


@cache
def _blanks(count: int) -> str:
    """The pattern of so many numbers."""
    return " ".join(["%.9g"] * count)


def add(parent: Element, tag: str, text: str | None = None, **attributes: str | float | Iterable[float]) -> Element:
    """A child element; numbers and vectors are written as text, a trailing underscore of a name is dropped."""
    child = ElementTree.SubElement(parent, tag, {name.rstrip("_"): _told(value) for name, value in attributes.items()})
    child.text = text
    return child


def _told(value: str | float | Iterable[float]) -> str:
    if isinstance(value, str):
        return value
    return number(value) if isinstance(value, int | float) else numbers(value)


def save(root: Element, path: Path) -> Path:
    """Write the document, indented by two."""
    lines = ['<?xml version="1.0" encoding="utf-8"?>']
    _write(root, "", lines)
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("\n".join(lines) + "\n", "utf-8")
    return path


def _write(element: Element, indent: str, lines: list[str]) -> None:
    """An element's lines behind others; none has both text and children."""
    told = "".join([f' {name}="{value}"' for name, value in element.items()])
    if SPECIAL.search(told) or told.count('"') > 2 * len(element.attrib):
        told = "".join([f' {name}="{_quoted(value)}"' for name, value in element.items()])
    head = f"{indent}<{element.tag}{told}"
    if len(element):
        lines.append(head + ">")
        for child in element:
            _write(child, indent + "  ", lines)
        lines.append(f"{indent}</{element.tag}>")
    else:
        lines.append(f"{head}>{escape(element.text, quote=False)}</{element.tag}>" if element.text else head + " />")


def _quoted(text: str) -> str:
    """An attribute's text without what would end it or be read as something else."""
    return "".join(ENTITIES.get(letter, letter) for letter in text)
