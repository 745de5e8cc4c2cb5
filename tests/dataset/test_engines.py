"""Engines of data sets: the same homes whoever makes them, also when a node dies; skipped without Ray, or submitit."""

import os
import signal
import sys
from functools import partial

import pytest

from apartgen.dataset import engines, on_submitit
from apartgen.dataset.build import build
from apartgen.dataset.source import Listed
from apartgen.dataset.store import Store
from apartgen.schemas.errors import BadInput

QUICK = {"layout": {"candidates": 1}, "plan": {"candidates": 1, "enough": 1}}
SLOW = "(__import__('time').sleep(0.2), {0} * {0})[1]"


@pytest.fixture
def cluster(monkeypatch):
    """Two nodes of one core each; the second can be killed."""
    ray = pytest.importorskip("ray")
    from ray.cluster_utils import Cluster

    monkeypatch.setenv("PYTHONPATH", os.path.dirname(os.path.dirname(__file__)), prepend=os.pathsep)
    found = Cluster(initialize_head=True, head_node_args={"num_cpus": 1})
    found.second = found.add_node(num_cpus=1)
    monkeypatch.setenv("RAY_ADDRESS", found.address)
    yield found
    ray.shutdown()
    found.shutdown()


def test_a_cluster_that_loses_a_node_loses_no_work(cluster, tmp_path):
    pieces = [SLOW.format(i) for i in range(40)]
    found = []
    for result in engines.engine("ray").results(eval, iter(pieces), None, partial(str.__add__, "lost "), tmp_path):
        found.append(result)
        if len(found) == 10:
            cluster.remove_node(cluster.second, allow_graceful=False)
    assert found == [i * i for i in range(40)]


def test_a_cluster_makes_the_same_homes(cluster, tmp_path):
    prompts = Listed(b"studio\nstudio\na 20 m2 flat with four bedrooms of 15 m2 each\n", "list")
    options = {"given": QUICK, "populate": False, "per_shard": 2}
    told = [build(prompts, tmp_path / name, workers=1, engine=name, **options) for name in ("local", "ray")]
    assert homes(told[0]) == homes(told[1])


def homes(store: Store) -> list[tuple[str, bytes]]:
    return [(row["id"], store.line(row) if "shard" in row else row["error"]) for row in store.rows()]


def test_jobs_answer_in_order_and_those_that_are_killed_are_done_one_by_one(monkeypatch, tmp_path):
    pytest.importorskip("submitit")
    monkeypatch.setattr(on_submitit, "A_JOB", 3)
    pieces = [f"{i} * {i}" for i in range(7)]
    pieces[4] = f"__import__('os').kill(__import__('os').getpid(), {int(signal.SIGKILL)})"
    found = list(on_submitit.results(eval, iter(pieces), 2, partial(str.__add__, "lost "), tmp_path))
    assert found == [f"lost {pieces[4]}" if i == 4 else i * i for i in range(7)]
    assert not list(tmp_path.iterdir()), "nothing is left"


def test_an_engine_that_is_not_there_is_bad_input(monkeypatch, tmp_path):
    with pytest.raises(BadInput, match="local, ray, submitit"):
        engines.engine("kubernetes")
    for name in ("ray", "submitit"):
        monkeypatch.setitem(sys.modules, name, None)
        with pytest.raises(BadInput, match="not installed"):
            list(engines.engine(name).results(eval, ["1"], 1, str, tmp_path))
