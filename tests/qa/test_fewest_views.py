"""Which views a question is asked of, by what each shows."""

from types import SimpleNamespace

import pytest

from apartgen.stages.qa.facts import Facts


def chosen(shown, ids, most):
    """Of eyes that each show so much of some things."""
    views = {name: SimpleNamespace(name=name, kind="eye") for name in shown}
    home = SimpleNamespace(render=SimpleNamespace(views=list(views.values())), views=views, shares=shown)
    return Facts.pictures(home, ids, most)


@pytest.mark.parametrize("most", [1, 2, 3, 4])
def test_no_more_views_are_taken_than_may_be(most) -> None:
    shown = {f"eye {k}": {f"thing {k}": 0.5} for k in range(6)}
    assert chosen(shown, [f"thing {k}" for k in range(most)], most) == [f"eye {k}" for k in range(most)]
    assert chosen(shown, [f"thing {k}" for k in range(most + 1)], most) == []


def test_the_view_of_most_comes_first_and_what_none_shows_is_not_asked() -> None:
    shown = {"a": {"x": 0.5}, "b": {"x": 0.5, "y": 0.5}, "c": {"z": 0.5}}
    assert chosen(shown, ["x", "y", "z"], 4) == ["b", "c"]
    assert chosen(shown, ["x", "w"], 4) == []
