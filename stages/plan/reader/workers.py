"""Those who work at home."""

from dataclasses import dataclass, field

from apartgen.stages.plan.reader.about import People

SPEAKERS = ("i", "me", "ich", "je", "j'", "yo", "moi", "我")


@dataclass
class Working:
    """Those who work at home, told of one after another; `everybody` where it is said of all who live there.

    `found` where something is said of it, `speaking` where those who live there say it, `people` whom it names.
    """

    alone: set[str] = field(default_factory=set)
    several: int = 0
    everybody: bool = False
    speaking: bool = False
    found: bool = False
    people: People | None = None
    words: str = ""

    @property
    def count(self) -> int:
        """How many they are: `I` and `my wife` are two, `he` may be somebody told of before."""
        named = {who for who in self.alone if who in SPEAKERS or " " in who or not who.isascii()}
        return max(self.several, len(named), int(bool(self.alone)))

    def add(self, many: int, who: str = "one") -> None:
        """Another is told of, or several at once."""
        if many == 1:
            self.alone.add("i" if who in SPEAKERS else who)
        else:
            self.several = max(self.several, many)
