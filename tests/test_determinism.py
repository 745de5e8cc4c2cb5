"""The same request gives the same bytes, in any process."""

import random
import uuid

import commandline
import numpy as np
import pytest
from commandline import timeless

PROMPT = "one-bedroom flat with a study"


@pytest.fixture(scope="module")
def first(tmp_path_factory):
    folder = tmp_path_factory.mktemp("first")
    done = commandline.program("make", PROMPT, "-o", f"{folder}/", "--seed", 11, PYTHONHASHSEED="0")
    assert done.code == 0, done.err
    return timeless(folder)


def test_the_order_of_hashes_changes_nothing(first, tmp_path):
    done = commandline.program("make", PROMPT, "-o", f"{tmp_path}/", "--seed", 11, PYTHONHASHSEED="1")
    assert done.code == 0, done.err
    second = timeless(tmp_path)
    assert set(second) == set(first)
    assert not [name for name in first if first[name] != second[name]]


def test_no_stage_asks_global_chance_or_a_unique_name(first, tmp_path, capsys, monkeypatch):
    def banned(*_args, **_kwargs):
        raise AssertionError("randomness enters as rng only")

    for name in ("random", "randint", "choice", "shuffle", "uniform", "seed"):
        monkeypatch.setattr(random, name, banned)
        if hasattr(np.random, name):
            monkeypatch.setattr(np.random, name, banned)
    for name in ("rand", "randn", "normal", "permutation"):
        monkeypatch.setattr(np.random, name, banned)
    for name in ("uuid1", "uuid4"):
        monkeypatch.setattr(uuid, name, banned)
    done = commandline.run(capsys, monkeypatch, "make", PROMPT, "-o", f"{tmp_path}/", "--seed", 11)
    assert done.code == 0, done.err
    second = timeless(tmp_path)
    assert not [name for name in first if first[name] != second[name]]
