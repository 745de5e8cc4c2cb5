"""How well the latent tells styles apart, and what its neighbours look like: the figures and the picture of the README.

`python -m apartgen.stages.retrieve.shape.study PICTURE.png` draws the picture and logs the figures.
"""

import json
import logging
import sys
from collections.abc import Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.retrieve.shape.designs import Design, Maker, drawn, embedded_maker, fields
from apartgen.stages.retrieve.shape.encoder import WEIGHTS, encode
from apartgen.stages.things.latents import INDEX, Index, index

LOG = logging.getLogger("apartgen")
Array = NDArray[np.float64]

NOISE = (0.5, 1.0)
"""Standard deviations of noise put on queries, for a generator that misses by as much."""
QUERIES, NEIGHBOURS, TILE = 20, 6, 120


def held_out(maker: Maker, variants: int = 3, seed: int = 99) -> list[Design]:
    """Pieces at sizes that training did not draw."""
    return list(drawn(maker, variants, np.random.default_rng(seed)))


def style_accuracy(maker: Maker, weights: Path = WEIGHTS, table: Path = INDEX) -> dict[str, float]:
    """Share of held-out pieces whose nearest indexed piece of their category has their style, by what is compared.

    `chance` is that of picking any indexed piece of the category.
    """
    known, queries = index(table), held_out(maker)
    category, style = np.array(known.category), np.array(known.style)
    latent, rng = encode(fields(maker, queries), weights), np.random.default_rng(0)
    rivals = [category == query.category for query in queries]

    def share(own: Array, theirs: Array) -> float:
        hits = [style[rows][np.argmin(np.square(theirs[rows] - one).sum(1))] == query.style
                for query, rows, one in zip(queries, rivals, own)]  # fmt: skip
        return round(float(np.mean(hits)), 3)

    out = {"chance": round(float(np.mean([(style[r] == q.style).mean() for q, r in zip(queries, rivals)])), 3)}
    out["size"] = share(np.log([query.size for query in queries]), np.log(known.size))
    out["latent"] = share(latent, known.latent)
    for sigma in NOISE:
        out[f"latent, noise {sigma}"] = share(latent + sigma * rng.normal(size=latent.shape), known.latent)
    return out | {"pieces": float(len(queries))}


def neighbours(known: Index, latent: Array, count: int) -> list[int]:
    """Rows of the nearest pieces of the whole library, each category and style once."""
    found: dict[tuple[str, str], int] = {}
    for row in np.argsort(np.square(known.latent - latent).sum(1)):
        found.setdefault((known.category[row], known.style[row]), int(row))
        if len(found) == count:
            break
    return list(found.values())


def picture(maker: Maker, path: Path, weights: Path = WEIGHTS, table: Path = INDEX) -> None:
    """A sheet of held-out pieces, one a row in two columns of rows, each followed by its nearest neighbours."""
    from PIL import Image

    from apartgen.stages.retrieve.preview import render

    known, queries = index(table), held_out(maker)
    chosen = [queries[i] for i in np.linspace(0, len(queries) - 1, QUERIES).astype(int)]
    latent = encode(fields(maker, chosen), weights)
    rows = []
    for query, z in zip(chosen, latent):
        near = neighbours(known, z, NEIGHBOURS)
        designs = [query, *(_design(known, row) for row in near)]
        tiles = [render.pictures([render.opened(maker.build(*design), 0.0)], TILE)[0] for design in designs]
        tiles[0] = _framed(tiles[0])
        rows.append(np.concatenate(tiles, 1))
    half = len(rows) // 2
    sheet = np.concatenate([np.concatenate(rows[:half]), np.concatenate(rows[half:])], 1)
    Image.fromarray(sheet).quantize(256).save(path, optimize=True)


def _design(known: Index, row: int) -> Design:
    d, w, h = (round(float(side), 3) for side in known.size[row])
    return Design(known.category[row], known.style[row], (d, w, h), int(known.seed[row]))


def _framed(tile: NDArray[np.uint8], width: int = 3) -> NDArray[np.uint8]:
    framed = tile.copy()
    for edge in (np.s_[:width], np.s_[-width:], np.s_[:, :width], np.s_[:, -width:]):
        framed[edge] = (30, 90, 160)
    return framed


def main(arguments: Sequence[str]) -> None:
    """Draws the picture and logs the figures."""
    logging.basicConfig(level=logging.INFO, format="%(message)s")
    maker = embedded_maker()
    LOG.info("%s", json.dumps(style_accuracy(maker), indent=1))
    picture(maker, Path(arguments[0]))


if __name__ == "__main__":
    main(sys.argv[1:])
