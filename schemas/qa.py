"""Questions about a home with their answers."""

from typing import Any, Literal

from pydantic import Field, model_validator

from apartgen.schemas.base import Record

Difficulty = Literal["easy", "medium", "hard"]


class Question(Record):
    """One question of several answers; `answer` is the letter of `value` among `options`.

    `images` are names of views; one that ends on `.marks` has numbers in it, at the pixels that `marks` tells. `videos`
    are files of films; a question has one or the other.
    `evidence` names the things that the answer is worked out from, and measured numbers.
    """

    id: str
    kind: str
    text: str
    options: list[str] = Field(min_length=2, max_length=26)
    answer: str
    value: str
    images: list[str] = Field(default_factory=list)
    videos: list[str] = Field(default_factory=list)
    marks: dict[str, tuple[int, int]] = Field(default_factory=dict)
    difficulty: Difficulty
    evidence: dict[str, Any] = Field(default_factory=dict)

    @model_validator(mode="after")
    def _shows_something(self) -> "Question":
        if bool(self.images) == bool(self.videos):
            raise ValueError("a question is about images or about videos")
        return self
