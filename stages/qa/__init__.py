"""Questions about a home for models that see: what they ask is computed from the artifact, never written by hand."""

import json
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from apartgen.schemas.layout import Layout
from apartgen.schemas.qa import Question
from apartgen.schemas.render import Render
from apartgen.stages import registry, seeds
from apartgen.stages.qa import marks
from apartgen.stages.qa.config import QaConfig
from apartgen.stages.qa.drafts import asked
from apartgen.stages.qa.facts import Facts
from apartgen.stages.qa.plain import on_pillow, told_apart
from apartgen.stages.scene.folder import add

PACKAGE = "apartgen.stages.qa.kinds"


def every_kind() -> dict[str, str]:
    """Every kind of question and what it asks."""
    return registry.members(PACKAGE)


def run(home: Layout, render: Render, config: QaConfig, rng: np.random.Generator) -> list[Question]:
    """Questions about a home that the views of it answer; BadInput for an unknown kind."""
    objects = {o.id: o for o in home.objects}
    numbers = marks.dealt(render, told_apart(home), seeds.lane(rng, "marks"),
                          lambda id, view, pixel: not on_pillow(objects[id], view, pixel))
    facts = Facts(home, render, numbers)
    found: list[Question] = []
    for name in config.kind or every_kind():
        lane = seeds.lane(rng, name)
        drafts = registry.load(PACKAGE, name).ask(facts, lane, config.each)
        found += asked(name, drafts, lane)
    return found


def numbered(questions: Sequence[Question], folder: Path) -> None:
    """Write the pictures with numbers in them that questions are about, beside those without, and list them."""
    add(folder, marks.draw(questions, folder))


def lines(questions: Sequence[Question], folder: str) -> str:
    """JSON lines as fine-tuning tools read them, pictures in `folder`."""
    return "".join(json.dumps(_line(question, folder), ensure_ascii=False) + "\n" for question in questions)


def _line(question: Question, folder: str) -> dict[str, object]:
    options = "\n".join(f"{chr(65 + k)}. {option}" for k, option in enumerate(question.options))
    shown = "<image>" * len(question.images) + "<video>" * len(question.videos)
    text = f"{shown}\n{question.text}\n{options}\nAnswer with the letter."
    messages = [{"role": "user", "content": text}, {"role": "assistant", "content": question.answer}]
    images = [f"{folder}/{marks.file_of(name)}" for name in question.images]
    videos = [f"{folder}/{name}" for name in question.videos]
    told = question.model_dump(mode="json", exclude={"images", "videos", "marks"})
    return {"messages": messages, "images": images, "videos": videos, **told,
            "marks": [[int(number), *at] for number, at in question.marks.items()]}
