"""Library indices that are made to do harm are refused, whatever is in them."""

import json

import numpy as np
import pytest
from safetensors.numpy import save_file

from apartgen.schemas.errors import BadInput
from apartgen.stages.retrieve.matching.indexed import TABLE_FILE, Entry, IndexedLibrary, write

ROW = ["a", "chair", "plain", 0, ""]
HEADER = {"version": 1, "name": "mine", "as": "folder", "assets": [ROW]}
SIZE, LATENT = np.ones((1, 3), np.float32), np.zeros((1, 32), np.float32)


def test_an_index_is_read_as_it_was_written(tmp_path):
    entry = Entry("a", "chair", "plain", 2, "by me", (0.5, 0.25, 1.0))
    write(tmp_path, "mine", "folder", [entry], LATENT)
    library = IndexedLibrary(tmp_path)
    assert (library.name, library.kind, library.entries) == ("mine", "folder", [entry])


@pytest.mark.parametrize("header, size, latent", [
    ([], SIZE, LATENT), ({}, SIZE, LATENT), (HEADER | {"assets": [ROW[:3]]}, SIZE, LATENT), (7, SIZE, LATENT),
    (HEADER | {"assets": {}}, SIZE, LATENT), (HEADER | {"name": []}, SIZE, LATENT), (HEADER, SIZE[:0], LATENT),
    (HEADER | {"assets": [ROW] * 2}, SIZE, LATENT), (HEADER, SIZE, LATENT[:, :7]), (HEADER, SIZE[:, :2], LATENT),
    (HEADER, SIZE * np.float32("nan"), LATENT), (HEADER, SIZE * -1, LATENT),
    (HEADER, SIZE, np.full((1, 32), np.inf, np.float32)),
    (HEADER, SIZE.astype(np.int64), LATENT), (HEADER | {"version": "1"}, SIZE, LATENT)])
def test_a_hostile_index_is_refused(tmp_path, header, size, latent):
    save_file({"size": np.ascontiguousarray(size), "latent": np.ascontiguousarray(latent)}, tmp_path / TABLE_FILE,
              metadata={"apartgen": json.dumps(header)})
    with pytest.raises(BadInput, match="not a readable library index"):
        IndexedLibrary(tmp_path)


def test_a_newer_index_is_told(tmp_path):
    save_file({"size": SIZE, "latent": LATENT}, tmp_path / TABLE_FILE,
              metadata={"apartgen": json.dumps(HEADER | {"version": 2})})
    with pytest.raises(BadInput, match="upgrade apartgen"):
        IndexedLibrary(tmp_path)
