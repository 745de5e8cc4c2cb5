"""How rules put a category of furniture in a room: what `categories.toml` says of it under `stands`."""

from dataclasses import dataclass

from pydantic import ConfigDict


@dataclass(frozen=True, kw_only=True)
class Stands:
    """Lengths in metres; what is worth something is worth a way of so many metres. `categories.toml` says the rest."""

    __pydantic_config__ = ConfigDict(extra="forbid")

    lean: float | None = None
    aside: bool = False
    anywhere: bool = False
    askew: bool = False
    any_angle: bool = False
    view: float = 0.0
    sides: float = 0.0
    before: float = 0.0
    drawn: float = 0.0
    middle: float = 0.0
    at_window: float = 0.0
    eyes: float = 0.0
    dazzled: bool = False
    bare_below: bool = False
    centred: bool = False
    round: bool = False
    all_round: bool = False
    widens: bool = False
    diner: bool = False
    filler: int = 0
    line: int = 9
    needed: float = 1.0
    spare: bool = False
