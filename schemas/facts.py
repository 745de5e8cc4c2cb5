"""What is wrong with a fact in a TOML file, in plain words."""

from collections.abc import Collection
from typing import Any

from pydantic import ValidationError

from apartgen.schemas.errors import near

SHOWN = 40
"""Letters of a wrong value that are shown."""
_PLAIN = {
    "unexpected_keyword_argument": "there is no fact of that name", "missing": "is missing",
    "too_long": "has {actual_length} values; it takes {max_length}", "tuple_type": "is no list; write [ … ]",
    "float": "is no number", "int": "is no whole number", "bool": "is neither true nor false",
    "string": "is no text; write it in quotes", "dict": "is no table; write {{ name = value }}",
    "dataclass": "is no table; write {{ name = value }}", "finite_number": "is no finite number",
    "literal_error": "is none of {expected}",
    "greater_than_equal": "is less than {ge:g}", "greater_than": "is not above {gt:g}",
    "less_than_equal": "is over {le:g}",
}
"""By how pydantic's name of a fault begins."""


def fault(error: ValidationError, known: Collection[str]) -> str:
    """The first that is wrong with facts by name, of which those `known` are allowed."""
    first = error.errors(include_url=False)[0]
    name, *inner = map(str, first["loc"])
    where = ".".join([name, *(part for part in inner if not part.isdecimal())])
    if first["type"] == "missing" and inner:
        return f"{where} has {inner[-1]} value{'s' * (inner[-1] != '1')}, which are too few"
    plain = (words.format(**first.get("ctx", {})) for kind, words in _PLAIN.items() if first["type"].startswith(kind))
    said = next(plain, first["msg"].lower())
    if first["type"].startswith("unexpected") and not inner:
        said += f"; {near(name, known)}"
    return f"{where}: {_shown(first)}{said}"


def _shown(first: Any) -> str:
    """The value that is wrong, where it is one."""
    value = first["input"]
    told = first["type"].startswith(("missing", "unexpected", "too_long"))
    return "" if told or isinstance(value, dict | list) else f"{str(value)[:SHOWN]!r} "
