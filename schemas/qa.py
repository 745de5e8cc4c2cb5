"""Questions about a home with their answers."""

from typing import Any, Literal

from pydantic import Field

from apartgen.schemas.base import Record

Difficulty = Literal["easy", "medium", "hard"]


class Question(Record):
    """One question of several answers; `answer` is the letter of `value` among `options`.

    `images` are names of views; one that ends on `.marks` has numbers in it, at the pixels that `marks` tells.
    `evidence` names the things that the answer is worked out from, and measured numbers.
    """

    id: str
    kind: str
    text: str
    options: list[str] = Field(min_length=2, max_length=26)
    answer: str
    value: str
    images: list[str] = Field(min_length=1)
    marks: dict[str, tuple[int, int]] = Field(default_factory=dict)
    difficulty: Difficulty
    evidence: dict[str, Any] = Field(default_factory=dict)
