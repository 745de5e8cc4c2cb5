"""The language-model reader: prompt to programme by structured output of any model that litellm knows."""

from pathlib import Path
from typing import Any

from apartgen.schemas.errors import Unmet
from apartgen.schemas.plan import Program
from apartgen.stages.plan.llm.answers import Broken, Declined, instructions, programme, reply_schema
from apartgen.stages.plan.llm.cache import Cache
from apartgen.stages.plan.llm.model import Answer, Model
from apartgen.stages.plan.reader import bounded, complete_program

REPAIRS = 1
"""How often a model may correct an invalid reply."""


def read(
    prompt: str,
    model: str,
    cache: Path | None = None,
    *,
    timeout: float = 60.0,
    retries: int = 2,
    backoff: float = 1.0,
    api_base: str | None = None,
) -> tuple[Program, dict[str, Any]]:
    """The programme a language model reads from a prompt, and what it took.

    `model` is a litellm name (`openai/gpt-4o-mini`, `ollama/…`); keys come from the environment and are never written.
    Replies are validated; one invalid reply is sent back with its error. `cache` is a folder of earlier answers.
    Returns the programme with areas and links completed, and `{"model", "prompt_tokens", "completion_tokens",
    "cost" (US dollars or None), "rounds", "cached"}`. Raises BadInput for an unknown model, a missing key or an absurd
    prompt, Unmet when the model declines, times out, or never gives a valid programme.
    """
    bounded(prompt)  # absurd requests end before anything is sent
    store = Cache(cache, model, prompt)
    kept = store.recalled()
    if kept is not None:
        return kept
    client = Model(model, timeout, retries, backoff, api_base)
    program, used = _ask(client, prompt)
    store.save(program, used)
    return program, used | {"cached": False}


def _ask(client: Model, prompt: str) -> tuple[Program, dict[str, Any]]:
    """One question and at most `REPAIRS` corrections."""
    messages = [
        {"role": "system", "content": instructions()},
        {"role": "user", "content": f"<description>{_plain(prompt)}</description>"},
    ]
    answers: list[Answer] = []
    problem = ""
    for _ in range(1 + REPAIRS):
        answer = client.complete(messages, reply_schema())
        answers.append(answer)
        try:
            return complete_program(programme(answer)), _used(client, answers)
        except Declined as e:
            raise Unmet(f"{client.name} declined the prompt: {e}; rephrase it, or leave out --llm") from e
        except Broken as e:
            problem = str(e)
        messages += [
            {"role": "assistant", "content": answer.text[:20000]},
            {
                "role": "user",
                "content": f"That reply is not valid: {problem}. Send the whole corrected JSON object, nothing else.",
            },
        ]
    raise Unmet(
        f"{client.name} gave no valid programme, corrected once: {problem}; try another model, or leave out --llm"
    )


def _plain(prompt: str) -> str:
    """The prompt cannot close the tag it stands in."""
    return prompt.replace("<", "‹").replace(">", "›")


def _used(client: Model, answers: list[Answer]) -> dict[str, Any]:
    costs = [a.cost for a in answers]
    return {
        "model": client.name,
        "prompt_tokens": sum(a.prompt_tokens for a in answers),
        "completion_tokens": sum(a.completion_tokens for a in answers),
        "cost": None if None in costs else round(sum(c or 0.0 for c in costs), 6),
        "rounds": len(answers),
    }
