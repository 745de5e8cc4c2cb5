"""Details of episodes: how long a frame shows, and how a hand lets go before it is drawn back."""

import numpy as np
import pytest
from embodied.test_interact import chest, flat, leaf, opened
from PIL import Image

from apartgen.stages.embodied import replay
from apartgen.stages.embodied.interact.parts import PLAY
from apartgen.stages.embodied.interact.plan import Planner
from apartgen.stages.embodied.outcome import Outcome, Trace

assert flat, "a fixture"


@pytest.mark.parametrize("times", [[3.0], [1.0, 1.05, 1.1], [0.0, 0.2, 0.4, 0.6]])
def test_a_replay_is_as_fast_as_the_episode(times, tmp_path):
    trace = Trace(joints=["x"], times=times, qpos=[[0.0]] * len(times))
    outcome = Outcome(episode="navigation", room="r_1", object="o", category="sofa", success=True, trace=trace)
    pictures = [np.full((12, 16, 3), 40 * k, np.uint8) for k in range(len(times))]
    gif, png = replay.save(pictures, tmp_path / "it.gif", outcome)
    shown = Image.open(gif)
    assert getattr(shown, "n_frames", 1) == len(times) and Image.open(png).size == (16, 12)
    if len(times) > 1:  # GIFs count hundredths of seconds
        assert shown.info["duration"] == pytest.approx(1000 * (times[1] - times[0]), abs=10)


def test_fingers_open_before_the_hand_is_drawn_back(flat, monkeypatch):
    plan, made = Planner.plan, []

    def only_pushed(*asked):
        made.append(plan(*asked) if asked[-1] else None)
        return made[-1]

    monkeypatch.setattr(Planner, "plan", only_pushed)
    assert opened(flat(leaf(), chest(0.3, 2.59))).success
    came, held, away, _, _ = next(found for found in made if found is not None).phases
    assert came.hold is None and held.hold.kind == "pinch"
    grip, loose, far = held.stops[-1].posture, away.stops[0].posture, away.stops[-1].posture
    assert loose[11:] == pytest.approx(grip[11:] + PLAY) and loose[:11] == pytest.approx(grip[:11])
    assert np.abs(far[:11] - grip[:11]).max() > 0.05
