"""Which builder makes which category and style."""

from collections.abc import Callable

from apartgen.stages.retrieve.furniture.kit import Kit

Builder = Callable[[Kit], None]
DESIGNS: dict[str, dict[str, Builder]] = {}


def design(category: str, *styles: str) -> Callable[[Builder], Builder]:
    """Registers a builder for some styles of a category."""

    def enter(builder: Builder) -> Builder:
        DESIGNS.setdefault(category, {}).update(dict.fromkeys(styles, builder))
        return builder

    return enter
