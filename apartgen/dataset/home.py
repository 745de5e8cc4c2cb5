"""One home of a data set: its request through every stage, and the row that the manifest has of it."""

import logging
from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager
from time import perf_counter
from typing import Any, NamedTuple

from apartgen import outputs, planning, settings
from apartgen.dataset import shape
from apartgen.requests import Request
from apartgen.schemas import artifact
from apartgen.schemas.artifact import Artifact
from apartgen.schemas.base import Record
from apartgen.schemas.errors import ApartgenError, BadInput
from apartgen.schemas.metrics import Value
from apartgen.stages import check, seeds
from apartgen.steps import POPULATE, STEPS, Step, lane, made

log = logging.getLogger("apartgen")
Settings = Mapping[str, Mapping[str, Any]]
DRAWS = 3
"""How often a home is drawn at most."""


class Asked(NamedTuple):
    """What a worker is given: a request with its seed, and the settings of the whole data set."""

    request: Request
    seed: int
    settings: Settings
    populate: bool = True
    """Whether small things are put into the home."""


class Done(NamedTuple):
    """What a worker gives: the line of the artifact, empty where there is none, and the manifest's row."""

    line: bytes
    row: dict[str, Any]


def steps_of(populate: bool) -> tuple[Step, ...]:
    """The stages after the plan."""
    return tuple(step for step in STEPS if populate or step is not POPULATE)


def home(asked: Asked) -> Done:
    """A home, or why there is none. It hangs on its request, its seed and the settings alone.

    One that a stage can't finish, or that the judge refuses, is thrown away and drawn again, `DRAWS` times in all; its
    row says so. Where none is better the first is taken.
    """
    began = perf_counter()
    done = [_drawn(asked, asked.seed)]
    while _may_do_better(asked, done[-1]) and len(done) < DRAWS:
        done.append(_drawn(asked, _other_seed(asked, len(done))))
    taken = min(done, key=_shortcoming)
    thrown_away = [_why(one) for one in done if one is not taken]
    seconds = taken.row["seconds"] | {"all": round(perf_counter() - began, 3)}
    return Done(taken.line, taken.row | ({"thrown_away": thrown_away} if thrown_away else {}) | {"seconds": seconds})


def _other_seed(asked: Asked, k: int) -> int:
    return int(seeds.drawn(asked.seed, "again", asked.request.id or asked.request.prompt, str(k)).integers(2**63))


def _shortcoming(done: Done) -> int:
    """0 for a certified home, 1 for one that the judge refuses, 2 for none."""
    return 2 if not done.line else int(not done.row["certified"])


def _may_do_better(asked: Asked, done: Done) -> bool:
    """A request that is wrong stays wrong, however it is drawn; a model that gives no programme is asked once."""
    asks_a_model = any(table.get("plan", {}).get("llm") for table in (asked.settings, asked.request.settings))
    hopeless = done.row.get("status") == BadInput.exit_code or asks_a_model and "plan" not in done.row["seconds"]
    return _shortcoming(done) > 0 and not hopeless


def _why(done: Done) -> str:
    return str(done.row.get("error") or done.row["faults"][0])


def _drawn(asked: Asked, seed: int) -> Done:
    """One draw."""
    row = row_of(asked)
    seconds: dict[str, float] = {}
    try:
        with _heard() as said:
            read, digests = _made(asked._replace(seed=seed), seconds)
        row |= {"said": said} if said else {}
        row |= {"kind": read.kind, "by": read.made.by, "digests": digests, **_judged(read, seconds)}
        line = artifact.line_of(read.body, read.made).encode()
    except ApartgenError as error:
        line = b""
        row |= {"error": str(error), "status": error.exit_code}
    return Done(line, row | {"seconds": seconds})


@contextmanager
def _heard() -> Iterator[list[str]]:
    """What stages have to say of a home, which the manifest keeps in place of a screen."""
    said: list[str] = []
    handler = logging.Handler()
    handler.emit = lambda record: said.append(record.getMessage())  # type: ignore[method-assign]
    before = log.handlers, log.propagate, log.level
    log.handlers, log.propagate = [handler], False
    log.setLevel(logging.INFO)
    try:
        yield said
    finally:
        log.handlers, log.propagate = before[:2]
        log.setLevel(before[2])


def row_of(asked: Asked) -> dict[str, Any]:
    """What the manifest says of a request; `request` is what it draws by, where that is not its words."""
    one = asked.request
    row = {"id": one.name, "request": one.id, "prompt": one.prompt, "seed": asked.seed, "settings": dict(one.settings)}
    return {name: value for name, value in row.items() if value not in ("", {})}


def _made(asked: Asked, seconds: dict[str, float]) -> tuple[Artifact[Any], dict[str, str]]:
    configs = settings.by_stage(_over(asked.settings, asked.request.settings), ["svg"])
    began = perf_counter()
    read = _plan(asked, configs["plan"])
    digests, began = {"plan": read.digest}, _lap(seconds, "plan", began)
    steps = steps_of(asked.populate)
    for step in steps:
        read = _next(step, read, configs[step.word], asked.seed)
        digests[step.word], began = read.digest, _lap(seconds, step.word, began)
    return read, digests | {f"{step.word} {name}": digest for step in steps
                            for name, digest in _data(step, configs[step.word]).items()}


def _plan(asked: Asked, config: Any) -> Artifact[Any]:
    # One thread: the cores are the workers', and the plan does not depend on it.
    drawn, used = planning.draw(asked.request.prompt, config.model_copy(update={"processes": 1}), asked.seed,
                                asked.request.id)
    record = made("plan", asked.seed, config).model_copy(update={"id": asked.request.id, "model": used})
    return artifact.settled(drawn, record)


def _next(step: Step, read: Artifact[Any], config: Record, seed: int) -> Artifact[Any]:
    outcome = next(iter(step.advance([step.taken(read).body], config, [lane(seed, step.word, read.body)])))
    if isinstance(outcome, ApartgenError):
        raise type(outcome)(f"{step.word}: {outcome}")
    return artifact.settled(outcome, made(step.word, seed, config, read, data=step.data(config)))


def _data(step: Step, config: Record) -> dict[str, str]:
    """Digests of the files that a stage hangs on, such as weights."""
    return made(step.word, 0, config, data=step.data(config)).inputs


def _over(settings: Settings, own: Settings) -> dict[str, dict[str, Any]]:
    """The settings of the data set, with what a request says of its own home."""
    return {word: {**settings.get(word, {}), **own.get(word, {})} for word in {*settings, *own}}


def _judged(read: Artifact[Any], seconds: dict[str, float]) -> dict[str, Any]:
    """What the judge, the metrics and the shape of a home say."""
    began = perf_counter()
    faults = check.run(read.body)
    began = _lap(seconds, "check", began)
    refusing = [str(fault) for fault in faults if fault.refuses]
    values = outputs.measure(read.body, outputs.MetricsSettings()).values
    _lap(seconds, "metrics", began)
    return {"certified": not refusing, "faults": refusing[:3], "notes": len(faults) - len(refusing),
            "metrics": _named(value for value in values if value.of == "apartment"), **shape.of(read.body)}


def _named(values: Iterable[Value]) -> dict[str, float | None]:
    """Figures by name; of one that is there in several versions the first, the others as `name/version`."""
    found: dict[str, float | None] = {}
    for value in values:
        found[f"{value.name}/{value.version}" if value.name in found else value.name] = value.value
    return found


def _lap(seconds: dict[str, float], word: str, began: float) -> float:
    now = perf_counter()
    seconds[word] = round(now - began, 3)
    return now
