"""The tables of docs/physics.md, drawn from the data."""

from apartgen.stages.things import mechanisms, small
from apartgen.stages.things.categories import TABLE


def text() -> str:
    """What weighs how much, what moves how, and where that is from."""
    return "\n".join([*_weights(), "", *_mechanisms(), "", *_small(), "", *_sources(), ""])


def _weights():
    yield "| furniture | kg | source |\n|---|---|---|"
    for name, kind in sorted(TABLE.items()):
        if kind.mass and not kind.like:
            yield f"| {name} | {kind.mass[0]:g} to {kind.mass[1]:g} | {kind.weighed} |"


def _mechanisms():
    yield ("| mechanism | of | friction | damping | holds shut | holds open | until | source |\n"
           "|---|---|---|---|---|---|---|---|")
    for name, row in mechanisms.table().items():
        own = sorted(k for k, kind in TABLE.items() if kind.mechanism == name and not kind.like)
        cells = (_span(row.friction), _span(row.damping), _span(row.catch), _span(row.rest), f"{row.travel:g}")
        yield f"| {name} | {', '.join(own) or '-'} | {' | '.join(cells)} | {row.source} |"


def _span(span):
    return f"{span[0]:g} to {span[1]:g}" if any(span) else "-"


def _small():
    yield "| small thing | g | friction |\n|---|---|---|"
    for name, kind in sorted(small.TABLE.items()):
        yield f"| {name} | {1000 * kind.mass[0]:g} to {1000 * kind.mass[1]:g} | {kind.friction:g} |"


def _sources():
    yield "| source | is |\n|---|---|"
    yield from (f"| {name} | {text} |" for name, text in mechanisms.sources().items())
