"""Source code as trees."""

import ast
import gc


def tree_of(source: str) -> ast.Module:
    """The tree of a module, with no garbage collected in between.

    CPython 3.11 loses count of a tree's depth where a callback of the collector runs Python, as hypothesis' does
    (`SystemError: AST constructor recursion depth mismatch`).
    """
    collecting = gc.isenabled()
    gc.disable()
    try:
        return ast.parse(source)
    finally:
        if collecting:
            gc.enable()
