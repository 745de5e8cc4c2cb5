"""The index of the embedded library: which piece has which latent.

`python -m apartgen.stages.retrieve.shape.catalogue` makes it anew with the present weights, after the library has
changed.
"""

import hashlib
import json
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from safetensors.numpy import save_file

from apartgen.stages.retrieve.shape.designs import Maker, embedded_maker, fields, indexed
from apartgen.stages.retrieve.shape.encoder import WEIGHTS, encode
from apartgen.stages.things.latents import INDEX


def write(maker: Maker, out: Path = INDEX, weights: Path = WEIGHTS) -> int:
    """Builds and encodes every indexed design; returns how many. The same library and weights give the same bytes."""
    designs = list(indexed(maker))
    latent = encode(fields(maker, designs), weights)
    record = {"weights": hashlib.sha256(weights.read_bytes()).hexdigest(), "pieces": len(designs)}
    header = {"category": [d.category for d in designs], "style": [d.style for d in designs], "record": record}
    tensors: dict[str, NDArray[Any]] = {
        "latent": latent.astype(np.float16),
        "seed": np.asarray([d.seed for d in designs], np.int8),
        "size": np.asarray([d.size for d in designs], np.float32),
    }
    save_file(tensors, out, metadata={"apartgen": json.dumps(header, sort_keys=True)})
    out.chmod(0o644)
    return len(designs)


if __name__ == "__main__":
    write(embedded_maker())
