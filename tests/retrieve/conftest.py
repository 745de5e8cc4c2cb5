"""A stand-in library of plain shapes, and rooms to place them in."""

from types import SimpleNamespace

import numpy as np
import pytest

from apartgen.schemas.errors import BadInput
from apartgen.schemas.layout import Layout
from apartgen.stages.things.asset import Array, Asset, Collider, Link, Material, Mesh

STYLES = ("block", "legs", "panel", "steps")
COLORS = {
    "block": (0.2, 0.2, 0.2, 1.0),
    "legs": (0.8, 0.6, 0.4, 1.0),
    "panel": (0.9, 0.9, 0.9, 1.0),
    "steps": (0.3, 0.5, 0.7, 1.0),
}
FACES = np.array(
    [
        [0, 2, 1],
        [0, 3, 2],
        [4, 5, 6],
        [4, 6, 7],
        [0, 1, 5],
        [0, 5, 4],
        [1, 2, 6],
        [1, 6, 5],
        [2, 3, 7],
        [2, 7, 6],
        [3, 0, 4],
        [3, 4, 7],
    ]
)


def box(lo: tuple[float, ...], hi: tuple[float, ...], material: Material) -> tuple[Mesh, Collider]:
    """A closed box between two corners."""
    a, b = np.asarray(lo, float), np.asarray(hi, float)
    low = np.array([[0, 0], [1, 0], [1, 1], [0, 1]], float)
    unit = np.concatenate([np.c_[low, np.zeros(4)], np.c_[low, np.ones(4)]])
    return Mesh(a + unit * (b - a), FACES, material), Collider("box", (a + b) / 2, b - a)


def _parts(style: str, half: Array) -> list[tuple[tuple[float, ...], tuple[float, ...]]]:
    x, y, z = half
    match style:
        case "block":
            return [((-x, -y, -z), (x, y, z))]
        case "legs":
            t = 0.15 * min(x, y)
            top = z - min(0.04, z)
            corners = [(sx * (x - t), sy * (y - t)) for sx in (-1, 1) for sy in (-1, 1)]
            return [((-x, -y, top), (x, y, z))] + [((cx - t, cy - t, -z), (cx + t, cy + t, top)) for cx, cy in corners]
        case "panel":
            return [((-x, -y, -z), (-0.8 * x, y, z)), ((-0.8 * x, -y, -z), (x, y, -0.8 * z))]
        case "steps":
            return [((-x, -y, -z), (x, y, 0)), ((-x, -y, 0), (0, y, z))]
    raise BadInput(f"no style {style}")


def styles(category: str) -> tuple[str, ...]:
    return STYLES


def build(
    category: str, style: str, size: tuple[float, float, float], seed: int = 0, right: bool = False
) -> Asset:
    material = Material(style, COLORS[style])
    made = [box(lo, hi, material) for lo, hi in _parts(style, np.asarray(size) / 2)]
    base = Link("base", [mesh for mesh, _ in made], [collider for _, collider in made], 10.0)
    return Asset(
        "parametric", f"{category}/{style}/{size[0]}x{size[1]}x{size[2]}/{seed}" + right * "/right", category,
        style, size, [base],
    )


def load_asset(id: str) -> Asset:
    category, style, size, seed, *right = id.split("/")
    d, w, h = (float(side) for side in size.split("x"))
    return build(category, style, (d, w, h), int(seed), bool(right))


@pytest.fixture(scope="session")
def maker():
    """A builder with the embedded library's interface."""
    return SimpleNamespace(styles=styles, build=build, load_asset=load_asset)


@pytest.fixture(scope="session")
def trained(maker, tmp_path_factory):
    """Weights and index of a small shape model of a few categories of the stand-in library."""
    pytest.importorskip("torch")
    from apartgen.stages.retrieve.shape import catalogue, designs, train
    from apartgen.stages.retrieve.shape.config import ShapeTraining

    few = ("chair", "sofa", "tv", "wardrobe")
    weights = tmp_path_factory.mktemp("shape") / "weights.safetensors"
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(train, "drawn", lambda maker, n, rng: designs.drawn(maker, n, rng, few))
        patch.setattr(catalogue, "indexed", lambda maker: designs.indexed(maker, few))
        train.train(ShapeTraining(variants=4, epochs=4), weights, maker=maker)
    return weights, weights.with_name("index.safetensors")


@pytest.fixture(scope="session")
def libraries(maker):
    """The stand-in library, open; each of its styles has a latent of its own."""
    from apartgen.stages.retrieve.matching.config import RetrieveConfig
    from apartgen.stages.retrieve.matching.embedded import Embedded
    from apartgen.stages.retrieve.matching.libraries import LibrarySet
    from apartgen.stages.retrieve.shape.designs import indexed
    from apartgen.stages.things.latents import Index

    rng = np.random.default_rng(0)
    middle = {style: rng.normal(size=32) for style in STYLES}
    rows = list(indexed(maker))
    latent = np.array([middle[row.style] for row in rows]) + 0.1 * rng.normal(size=(len(rows), 32))
    columns = ([row.category for row in rows], [row.style for row in rows])
    seed, size = np.array([row.seed for row in rows]), np.array([row.size for row in rows])
    return LibrarySet(Embedded(RetrieveConfig(), Index(*map(tuple, columns), seed, size, latent, {}), maker), [])


@pytest.fixture
def flat():
    """Makes a layout of one room, 4 × 5 m, holding the given objects."""

    def make(*objects: dict, type: str = "bedroom") -> Layout:
        room = f"{type}_1"
        rooms = [{"id": room, "type": type, "polygon": [[0, 0], [4, 0], [4, 5], [0, 5]]}]
        door = {
            "id": "d",
            "kind": "entrance",
            "rooms": [room],
            "segment": [[3, -0.15], [3.9, -0.15]],
            "sill": 0,
            "head": 2,
        }
        named = [{"id": f"o{i}", "room": room, "yaw": 0.0} | each for i, each in enumerate(objects)]
        return Layout(program={"rooms": rooms}, rooms=rooms, openings=[door], objects=named)

    return make
