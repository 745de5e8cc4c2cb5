"""What stands in for an object opens where it stands."""

from types import SimpleNamespace

import handmade as h
import numpy as np
import pytest

from apartgen.schemas.retrieve import AssetKey
from apartgen.stages import retrieve
from apartgen.stages.walkable import kinds
from apartgen.stages.walkable.config import WalkableConfig
from apartgen.stages.walkable.kinds import stand_ins
from apartgen.stages.walkable.leaves import building
from apartgen.stages.walkable.parts import Check
from apartgen.stages.walkable.site import survey
from apartgen.stages.walkable.solids import Solids


@pytest.mark.parametrize("x", [4.5, 4.9, 6.5])
def test_no_shower_for_a_bath_opens_into_a_door_that_stands_open(x: float) -> None:
    """A bath at the bedroom's south wall; the leaf of its door stands open from the west wall at y = 1, to x = 5."""
    bath = h.thing("bath", x, 0.36, np.pi / 2, h.BEDROOM, size=(0.7, 1.4, 0.56), id="bath")
    libraries = retrieve.open_libraries()
    asset = libraries.nearest("bath", bath.size, (), bath.size)
    bath = bath.model_copy(update={"asset": AssetKey(library=asset.library, id=asset.id)})
    home = h.home(bath)
    check = Check(building(home), Solids(libraries))
    showers = [to["bath"] for to in stand_ins(survey(home, WalkableConfig(), libraries), (bath,), bath)
               if to["bath"].category == "shower"]
    for shower in showers:
        assert not {fault.by for fault in check.blocked([shower]) if fault.owner == "bath"}, shower.asset
    assert showers or x < 6


@pytest.mark.parametrize("styles, wanted", [(["b", "a", "c", "a"], ["a", "a", "b", "c"]), ([], ["nearest"])])
def test_designs_of_its_own_style_come_first_and_where_there_are_none_the_nearest(styles, wanted, monkeypatch) -> None:
    monkeypatch.setattr(kinds, "look", lambda *_: ("a", "oak"))
    library = SimpleNamespace(alternatives=lambda *_: map(styled, styles), nearest=lambda *_: styled("nearest"))
    bath = h.thing("bath", 5.0, 0.36, room=h.BEDROOM)
    found = kinds._assets(SimpleNamespace(library=library), bath, "shower", np.array([0.9, 0.9, 2.0]))
    assert [asset.style for asset in found] == wanted


def styled(name: str) -> SimpleNamespace:
    return SimpleNamespace(style=name)
