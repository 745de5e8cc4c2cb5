"""Where a simulator looks first."""

import mujoco
import pytest


def test_mujoco_looks_at_the_middle_of_the_flat(exported):
    # Floors from (0, 0) to (9, 6.4).
    model = mujoco.MjModel.from_xml_path(str(exported("mjcf") / "mjcf" / "apartment.xml"))
    assert model.stat.center == pytest.approx([4.5, 3.2, 1.0])
    assert model.stat.extent == pytest.approx(9 / 1.6)
