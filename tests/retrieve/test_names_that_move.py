"""What a node's name says of whether it opens."""

import pytest

from apartgen.stages.retrieve.reading import motion


@pytest.mark.parametrize(("name", "opens"), [
    ("door", True), ("left_door", True), ("Drawer_03", True), ("flap.001", True), ("lid", True), ("shelf", False),
    ("body", False), ("", False), ("door_frame", False), ("drawer knob", False), ("door handle", False),
    ("flat bed", False)])
def test_doors_drawers_lids_and_flaps_open_but_not_what_belongs_to_them(name, opens):
    assert motion.moves(name) is opens
