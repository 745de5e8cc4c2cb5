"""What a library reader yields: an id, and how to load the asset."""

from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

from apartgen.stages.retrieve.reading.limits import Broken, inside, read
from apartgen.stages.things.asset import Asset

CREDIT_FILES = ("LICENSE", "LICENSE.txt", "License.txt", "LICENSE.md", "LICENCE", "COPYING", "license.txt")
APACHE = "Apache License"


class Source(NamedTuple):
    """One asset to be; `load` raises BadInput with the reason when it is broken."""

    id: str
    load: Callable[[], Asset]


def beside(file: Path, root: Path) -> Callable[[str], bytes | None]:
    """Opens what a model names by relative address, never outside `root`."""

    def opened(name: str) -> bytes | None:
        path = file.parent / name.replace("\\", "/").replace("%20", " ")
        real = inside(root, path)
        return read(real) if real.is_file() else None

    return opened


def image(file: Path, root: Path) -> Callable[[str], str | None]:
    """Where an image that a model names lies; None when it is missing or outside `root`."""

    def found(name: str) -> str | None:
        try:
            real = inside(root, file.parent / name.replace("\\", "/"))
        except Broken:
            return None
        return str(real) if real.is_file() else None

    return found


def credit(root: Path) -> str:
    """What a library's licence file says of its makers, in one line; its folder's name without one."""
    for name in CREDIT_FILES:
        if (root / name).is_file():
            lines = [line.strip() for line in read(root / name, 2**20).decode("utf-8", errors="replace").splitlines()]
            told = [line for line in lines if line and not set(line) <= set("-=*#")]
            if told and told[0] == APACHE:
                return f"{root.name}, Apache-2.0"
            return f"{root.name}: {' · '.join(told[:5])}"[:300]
    return root.name


def files(root: Path, suffixes: tuple[str, ...]) -> list[Path]:
    """Files below `root` of these suffixes, in order of path; links that lead out are passed over."""
    real = root.resolve()
    found = (p for p in sorted(root.rglob("*")) if p.suffix.lower() in suffixes and p.is_file())
    return [p for p in found if p.resolve().is_relative_to(real)]
