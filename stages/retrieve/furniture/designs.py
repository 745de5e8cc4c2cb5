"""Which builder makes which category and style."""

from collections.abc import Callable
from typing import Protocol

from apartgen.schemas.errors import BadInput
from apartgen.stages.retrieve.furniture.kit import Kit


class Builder(Protocol):
    """Makes a piece of furniture: fills the kit's fixed body and gives it moving parts, within the kit's box."""

    __module__: str

    def __call__(self, kit: Kit) -> None:
        """`kit` knows category, style, size in metres, and chance that hangs on the seed."""


DESIGNS: dict[str, dict[str, Builder]] = {}


def design(category: str, *styles: str) -> Callable[[Builder], Builder]:
    """Registers a builder for some styles of a category; BadInput for a style that it has already."""
    if not styles or not all(isinstance(name, str) for name in (category, *styles)):
        raise BadInput('a builder is entered by @design("category", "style")')

    def enter(builder: Builder) -> Builder:
        taken = DESIGNS.setdefault(category, {})
        for style in styles:
            if taken.setdefault(style, builder).__module__ != builder.__module__:
                raise BadInput(f"{category} has a style {style!r} already, of {taken[style].__module__}; "
                               f"call that of {builder.__module__} otherwise")
        return builder

    return enter
