"""The shape latent: what it is blind to, what it tells apart, and the shipped weights and index."""

import json
from dataclasses import replace

import numpy as np
import pytest
from safetensors import safe_open

from apartgen.stages.retrieve.shape import encoder, fields
from apartgen.stages.retrieve.shape.designs import drawn, indexed
from apartgen.stages.things import latents
from apartgen.stages.things.categories import CATEGORIES


def test_field_of_a_stretched_piece_is_that_of_the_piece(maker):
    small, large = (maker.build("chair", "steps", size) for size in ((0.5, 0.5, 0.8), (1.0, 0.6, 2.0)))
    assert np.abs(fields.field(small) - fields.field(large)).mean() < 0.02


def test_surface_points_lie_on_the_surface_and_cover_it_evenly(maker):
    points, _ = fields.surface(maker.build("chair", "block", (0.5, 0.5, 0.8)))
    assert np.allclose(np.abs(points).max(1), 1)
    sides = [(points[:, axis] == side).mean() for axis in range(3) for side in (-1, 1)]
    assert np.allclose(sides, 1 / 6, atol=0.01)


def test_colours_are_part_of_the_field(maker):
    asset = maker.build("chair", "block", (0.5, 0.5, 0.8))
    mesh = asset.links[0].visuals[0]
    red = replace(mesh, material=replace(mesh.material, color=(1.0, 0.0, 0.0, 1.0)))
    painted = replace(asset, links=[replace(asset.links[0], visuals=[red])])
    a, b = fields.field(asset), fields.field(painted)
    assert np.array_equal(a[: fields.SHAPE], b[: fields.SHAPE])
    assert np.allclose(b[fields.SHAPE :].reshape(-1, 3), (1, 0, 0))


def test_encoder_without_torch_is_the_trained_one(trained, maker):
    torch = pytest.importorskip("torch")
    from safetensors.torch import load_file

    from apartgen.stages.retrieve.shape.vae import ShapeVAE

    weights = load_file(trained[0])
    model = ShapeVAE(1)
    own = {k: v.float() for k, v in weights.items() if not k.startswith("latent")}
    model.load_state_dict(own | {"style.weight": model.style.weight, "style.bias": model.style.bias})
    x = np.stack([fields.field(maker.build("sofa", style, (0.9, 2.0, 0.8))) for style in maker.styles("sofa")])
    with torch.no_grad():
        mean = model.posterior(torch.from_numpy(x))[0]
    standard = (mean - weights["latent.mean"]) / weights["latent.std"]
    assert np.allclose(standard, encoder.encode(x, trained[0]), atol=1e-4)


def test_training_is_reproducible_and_resumes_to_the_same_weights(maker, tmp_path, monkeypatch):
    torch = pytest.importorskip("torch")
    from apartgen.stages.retrieve.shape import designs, train
    from apartgen.stages.retrieve.shape.config import ShapeTraining

    few = tuple(CATEGORIES[:4])
    monkeypatch.setattr(train, "drawn", lambda m, n, rng: designs.drawn(m, n, rng, few))
    monkeypatch.setattr(train.catalogue, "indexed", lambda m: designs.indexed(m, few))
    config = ShapeTraining(variants=2, epochs=4)
    threads = torch.get_num_threads()
    torch.set_num_threads(1)
    whole, broken = tmp_path / "whole" / "w.safetensors", tmp_path / "broken" / "w.safetensors"
    train.train(config, whole, maker=maker)
    with safe_open(str(whole), "np") as file:
        record, std = json.loads(file.metadata()["apartgen"])["record"], file.get_tensor("latent.std")
    assert record["active_dimensions"] == (std**2 > 0.01).sum() > 0, "those that tell designs apart"
    epoch = train._epoch

    def stop(*args):
        if args[-1] == 2:
            raise KeyboardInterrupt
        return epoch(*args)

    monkeypatch.setattr(train, "_epoch", stop)
    with pytest.raises(KeyboardInterrupt):
        train.train(config, broken, maker=maker)
    monkeypatch.setattr(train, "_epoch", epoch)
    train.train(config, broken, maker=maker)
    torch.set_num_threads(threads)
    from safetensors.numpy import load_file

    a, b = load_file(whole), load_file(broken)
    assert all(np.array_equal(a[name], b[name]) for name in a)
    assert (tmp_path / "whole/index.safetensors").read_bytes() != b"" and not list(tmp_path.glob("*/*.work"))


def test_shipped_index_is_of_the_shipped_library_and_weights():
    from apartgen.stages.retrieve import furniture

    table = latents.index()
    for category in CATEGORIES:
        assert set(latents.latents(category)[0]) <= set(furniture.styles(category)), category
    assert encoder.WEIGHTS.stat().st_size < 3e6 and latents.INDEX.stat().st_size < 2e6
    assert np.abs(table.latent.mean(0)).max() < 0.25 and np.abs(table.latent.std(0) - 1).max() < 0.25
    assert len(list(indexed(furniture))) == len(table.category)


def test_shipped_latent_finds_the_style_that_size_alone_does_not():
    """Over pieces of sizes never trained on; a few of every category."""
    from apartgen.stages.retrieve import furniture

    table = latents.index()
    category, style = np.array(table.category), np.array(table.style)
    held = list(drawn(furniture, 1, np.random.default_rng(5), CATEGORIES[::4]))
    z = encoder.latents(furniture.build(*design) for design in held)
    hits = {"size": 0, "latent": 0}
    for design, own in zip(held, z, strict=True):
        rows = category == design.category
        for name, offset in (("latent", table.latent[rows] - own), ("size", np.log(table.size[rows] / design.size))):
            hits[name] += style[rows][np.argmin(np.square(offset).sum(1))] == design.style
    assert hits["latent"] > 0.8 * len(held) and hits["size"] < 0.5 * len(held)


def test_latents_by_style():
    styles, means = latents.style_latents("sofa")
    every, all_ = latents.latents("sofa")
    assert styles == sorted(set(every)) and means.shape == (len(styles), 32)
    assert np.allclose(means[0], all_[[s == styles[0] for s in every]].mean(0))
