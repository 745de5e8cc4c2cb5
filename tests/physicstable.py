"""The tables of docs/physics.md, drawn from the data."""

from apartgen.stages.things import mechanisms, small
from apartgen.stages.things.categories import TABLE


def text() -> str:
    """What weighs how much, what moves how, what rubs how, and where that is from."""
    tables = (_weights(), _mechanisms(), _ranges(), _damped(), _small(), _surfaces(), _sources())
    return "\n".join(line for table in tables for line in (*table, ""))


def _weights():
    yield "| furniture | kg | sources give | as | source |\n|---|---|---|---|---|"
    for name, kind in sorted(TABLE.items()):
        if kind.mass and not kind.like:
            yield f"| {name} | {_span(kind.mass)} | {_cells(kind)} |"


def _cells(kind, scale=1):
    """What sources give, what they call it, and their names."""
    given = tuple(scale * kg for kg in kind.listed) if kind.listed else (0, 0)
    return f"{_span(given)} | {kind.entry or '-'} | {', '.join(kind.weighed) or 'none found'}"


def _mechanisms():
    yield ("| mechanism | of | friction | damping | holds shut | holds open | until |\n"
           "|---|---|---|---|---|---|---|")
    for name, row in mechanisms.table().items():
        own = sorted(k for k, kind in TABLE.items() if kind.mechanism == name and not kind.like)
        cells = (_span(row.friction), _span(row.damping), _span(row.catch), _span(row.rest), f"{row.travel:g}")
        yield f"| {name} | {', '.join(own) or '-'} | {' | '.join(cells)} |"


def _ranges():
    yield ("| mechanism | pull, N | source | turns, degrees | slides, of its depth or width | source |\n"
           "|---|---|---|---|---|---|")
    for name, row in mechanisms.table().items():
        cells = (_span(row.force), row.source, _span(row.turn), _span(row.out), row.turned)
        yield f"| {name} | {' | '.join(cells)} |"


def _damped():
    yield "| mechanism | damping | sources give | of | source |\n|---|---|---|---|---|"
    for name, row in mechanisms.table().items():
        yield f"| {name} | {_span(row.damping)} | {_span(row.drag)} | {row.drags or '-'} | {', '.join(row.dragged)} |"


def _span(span):
    alone = f"{span[0]:.6g}"
    return "-" if not any(span) else alone if span[0] == span[1] else f"{alone} to {span[1]:.6g}"


def _small():
    yield "| small thing | g | sources give | as | source | friction | surface |\n|---|---|---|---|---|---|---|"
    for name, kind in sorted(small.TABLE.items()):
        span = _span(tuple(1000 * kg for kg in kind.mass))
        yield f"| {name} | {span} | {_cells(kind, 1000)} | {kind.friction:g} | {kind.surface} |"


def _surfaces():
    yield "| surface | friction at rest | source |\n|---|---|---|"
    yield from (f"| {name} | {_span(row.friction)} | {row.source} |" for name, row in mechanisms.surfaces().items())


def _sources():
    yield "| source | is |\n|---|---|"
    yield from (f"| {name} | {text} |" for name, text in mechanisms.sources().items())
