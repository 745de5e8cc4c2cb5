"""A file of built assets gives back what was put in."""

import time

import numpy as np
import pytest

from apartgen.schemas.errors import BadInput
from apartgen.stages.retrieve import furniture
from apartgen.stages.retrieve.furniture import pack
from apartgen.stages.things import categories


def everything(seed):
    return [
        furniture.build(name, style, categories.TABLE[name].size, seed)
        for name in categories.TABLE
        for style in furniture.styles(name)
    ]


def test_a_pack_gives_back_every_asset(tmp_path):
    assets = everything(1)
    pack.write(assets, tmp_path / "all.safetensors")
    for before, after in zip(assets, pack.read(tmp_path / "all.safetensors"), strict=True):
        assert (after.id, after.size, after.joints) == (before.id, before.size, before.joints)
        for one, other in zip(before.links, after.links, strict=True):
            assert (one.name, one.mass, one.grip, one.friction) == (other.name, other.mass, other.grip, other.friction)
            assert np.array_equal(np.asarray(one.handle), np.asarray(other.handle))
            for a, b in zip(one.visuals, other.visuals, strict=True):
                assert a.material == b.material and np.array_equal(a.faces, b.faces)
                assert np.allclose(a.vertices, b.vertices, atol=1e-6) and np.allclose(a.uv, b.uv, atol=1e-5)
            for a, b in zip(one.colliders, other.colliders, strict=True):
                assert (
                    a.kind == b.kind and np.array_equal(a.center, b.center) and np.array_equal(a.rotation, b.rotation)
                )
                assert np.array_equal(a.size, b.size)
                assert a.vertices is None if b.vertices is None else np.allclose(a.vertices, b.vertices, atol=1e-6)


def test_a_missing_or_broken_pack_is_refused(tmp_path):
    broken = tmp_path / "broken.safetensors"
    broken.write_bytes(b"\x08\0\0\0\0\0\0\0{}      ")
    for path in (tmp_path / "none.safetensors", broken):
        with pytest.raises(BadInput):
            pack.read(path)


@pytest.mark.slow
def test_a_thousand_assets_build_in_ten_seconds_and_load_in_one(tmp_path):
    start = time.process_time()
    assets = (everything(1) + everything(2) + everything(3) + everything(4))[:1000]
    built = time.process_time()
    pack.write(assets, tmp_path / "all.safetensors")
    before = time.process_time()
    assert len(pack.read(tmp_path / "all.safetensors")) == 1000
    assert built - start < 10 and time.process_time() - before < 1
