"""Small faults that a program may have: one operator, sign, number or argument of a source file another."""

import ast
import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

COMPARISONS = {
    ast.Lt: ("<", ">="), ast.LtE: ("<=", ">"), ast.Gt: (">", "<="), ast.GtE: (">=", "<"), ast.Eq: ("==", "!="),
    ast.NotEq: ("!=", "=="), ast.In: ("in", "not in"), ast.NotIn: ("not in", "in"), ast.Is: ("is", "is not"),
    ast.IsNot: ("is not", "is"),
}
BY_ONE = {ast.Lt: ("<", "<="), ast.LtE: ("<=", "<"), ast.Gt: (">", ">="), ast.GtE: (">=", ">")}
SIGNS = {ast.Add: ("+", "-"), ast.Sub: ("-", "+"), ast.Mult: ("*", "/"), ast.Div: ("/", "*")}
JOINTS = {ast.And: ("and", "or"), ast.Or: ("or", "and")}
MASKS = {ast.BitAnd: ("&", "|"), ast.BitOr: ("|", "&")}
OTHERS = {
    "min": "max", "max": "min", "minimum": "maximum", "maximum": "minimum", "argmin": "argmax", "argmax": "argmin",
    "any": "all", "all": "any", "floor": "ceil", "ceil": "floor", "cos": "sin", "sin": "cos",
}
EITHER_WAY = {"min", "max", "minimum", "maximum", "isclose", "allclose", "hypot", "array_equal", "zip", "isdisjoint"}
"""Calls whose first two arguments may change places."""


@dataclass(frozen=True)
class Change:
    """Bytes `start` to `end` of a file become `new`; `first` to `last` are the lines of the statement around them."""

    file: str
    kind: str
    start: int
    end: int
    new: str
    line: int
    first: int
    last: int
    function: str
    compiled: bool

    def applied(self, source: bytes) -> bytes:
        """The file with its fault."""
        return source[: self.start] + self.new.encode() + source[self.end :]

    def is_code(self, source: bytes) -> bool:
        """Whether Python reads the file with its fault."""
        try:
            ast.parse(self.applied(source))
        except SyntaxError:
            return False
        return True

    def lines(self, source: bytes) -> tuple[str, str]:
        """The line before and after, stripped."""
        changed = self.applied(source).decode().splitlines()
        return source.decode().splitlines()[self.line - 1].strip(), changed[self.line - 1].strip()


@dataclass
class _Place:
    """Where in a file a node stands."""

    function: str = ""
    compiled: bool = False
    first: int = 0
    last: int = 0


class _File:
    def __init__(self, file: str, source: bytes) -> None:
        self.file, self.source, self.found = file, source, list[Change]()
        self.starts = [0]
        for line in source.splitlines(keepends=True):
            self.starts.append(self.starts[-1] + len(line))

    def span(self, node: ast.expr) -> tuple[int, int]:
        end_line, end = node.end_lineno or node.lineno, node.end_col_offset or 0
        return self.starts[node.lineno - 1] + node.col_offset, self.starts[end_line - 1] + end

    def add(self, kind: str, place: _Place, start: int, end: int, new: str) -> None:
        line = self.source.count(b"\n", 0, start) + 1
        change = Change(self.file, kind, start, end, new, line, place.first, place.last, place.function, place.compiled)
        self.found.append(change)

    def between(self, kind: str, place: _Place, left: ast.expr, right: ast.expr, swap: tuple[str, str]) -> None:
        """Another operator between two operands."""
        (_, lo), (hi, _) = self.span(left), self.span(right)
        old, new = swap
        pattern = rf"\b{old}\b".replace(" ", r"\s+") if old.isalpha() or " " in old else re.escape(old)
        if match := re.search(pattern.encode(), self.source[lo:hi]):
            self.add(kind, place, lo + match.start(), lo + match.end(), new)


def changes(file: str, source: bytes) -> list[Change]:
    """All changes of a file; what is only written for the reader (types, words, names) stays."""
    found = _File(file, source)
    for node in ast.parse(source).body:
        _look(node, found, _Place())
    return found.found


def _look(node: ast.AST, file: _File, place: _Place) -> None:
    if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
        decorators = " ".join(ast.unparse(one) for one in node.decorator_list)
        compiled = place.compiled or bool(re.search(r"\b(n?jit|inner|once|compiled)\b", decorators))
        place = _Place(f"{place.function}.{node.name}".strip("."), compiled)
    elif isinstance(node, ast.ClassDef):
        place = _Place(f"{place.function}.{node.name}".strip("."), place.compiled)
    if isinstance(node, ast.stmt):
        inside = getattr(node, "body", None)
        last = inside[0].lineno - 1 if inside else node.end_lineno or node.lineno
        place = _Place(place.function, place.compiled, node.lineno, max(node.lineno, last))
    if isinstance(node, ast.Assert | ast.Raise | ast.Import | ast.ImportFrom):
        return
    for kind in (_compare, _operate, _call, _number):
        kind(node, file, place)
    for name, value in ast.iter_fields(node):
        if name not in ("annotation", "returns", "decorator_list", "type_params"):
            for child in value if isinstance(value, list) else [value]:
                if isinstance(child, ast.AST):
                    _look(child, file, place)


def _compare(node: ast.AST, file: _File, place: _Place) -> None:
    if isinstance(node, ast.Compare):
        for left, op, right in zip([node.left, *node.comparators], node.ops, node.comparators):
            file.between("comparison", place, left, right, COMPARISONS[type(op)])
            if type(op) in BY_ONE and (_counts(left) or _counts(right)):
                file.between("off by one", place, left, right, BY_ONE[type(op)])
    if isinstance(node, ast.BoolOp):
        file.between("and, or", place, node.values[0], node.values[1], JOINTS[type(node.op)])
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.Not | ast.USub):
        kind = "dropped not" if isinstance(node.op, ast.Not) else "sign"
        file.add(kind, place, file.span(node)[0], file.span(node.operand)[0], "")


def _operate(node: ast.AST, file: _File, place: _Place) -> None:
    if isinstance(node, ast.BinOp) and type(node.op) in SIGNS and not _text(node.left) and not _text(node.right):
        file.between("sign", place, node.left, node.right, SIGNS[type(node.op)])
    if isinstance(node, ast.BinOp) and type(node.op) in MASKS:
        file.between("and, or", place, node.left, node.right, MASKS[type(node.op)])


def _call(node: ast.AST, file: _File, place: _Place) -> None:
    if not isinstance(node, ast.Call):
        return
    name = node.func.attr if isinstance(node.func, ast.Attribute) else getattr(node.func, "id", "")
    if name in OTHERS:
        end = file.span(node.func)[1]
        file.add("other function", place, end - len(name), end, OTHERS[name])
    if name == "range" and not isinstance(node.args[-1], ast.Starred):
        _, end = file.span(node.args[min(1, len(node.args) - 1)])
        file.add("off by one", place, end, end, " - 1")
    plain = [arg for arg in node.args[:2] if not isinstance(arg, ast.Starred | ast.Constant | ast.GeneratorExp)]
    if len(plain) == 2 and name not in EITHER_WAY | {"isinstance", "getattr", "range", "cast", "partial"}:
        (a, b), (c, d) = map(file.span, plain)
        if file.source[a:b] == file.source[c:d]:
            return
        file.add("swapped", place, a, d, (file.source[c:d] + file.source[b:c] + file.source[a:b]).decode())


def _number(node: ast.AST, file: _File, place: _Place) -> None:
    """Named numbers of a module, and what something is compared with."""
    if isinstance(node, ast.Assign | ast.AnnAssign) and not place.function:
        target = node.targets[0] if isinstance(node, ast.Assign) else node.target
        named = [target, *getattr(target, "elts", [])]
        if node.value is not None and all(getattr(one, "id", "A").strip("_").isupper() for one in named):
            _doubled([one for one in ast.walk(node.value) if _is_number(one)], file, place)
    if isinstance(node, ast.Compare):
        _doubled([one for one in (node.left, *node.comparators) if _is_number(one)], file, place)


def _doubled(numbers: list[ast.AST], file: _File, place: _Place) -> None:
    for one in numbers:
        assert isinstance(one, ast.Constant) and isinstance(one.value, int | float)
        new = repr(one.value + 1) if isinstance(one.value, int) else repr(2 * one.value or 1.0)
        file.add("number", place, *file.span(one), new)


def _is_number(node: ast.AST) -> bool:
    return isinstance(node, ast.Constant) and type(node.value) in (int, float)


def _counts(node: ast.expr) -> bool:
    whole = isinstance(node, ast.Constant) and type(node.value) is int
    return whole or (isinstance(node, ast.Call) and getattr(node.func, "id", "") == "len")


def _text(node: ast.expr) -> bool:
    return isinstance(node, ast.JoinedStr) or (isinstance(node, ast.Constant) and isinstance(node.value, str))


def sources(root: Path, parts: tuple[str, ...]) -> Iterator[str]:
    """Files below some folders that hold code, relative to the root."""
    for part in parts:
        names = (str(path.relative_to(root)) for path in (root / part).rglob("*.py"))
        yield from sorted(name for name in names if (root / name).resolve() == root.resolve() / name)
