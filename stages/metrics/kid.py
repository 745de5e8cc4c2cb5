"""KID: kernel distance of image features, generated from real rooms seen from above."""

from collections.abc import Sequence

from apartgen.schemas.layout import Layout
from apartgen.schemas.metrics import Value
from apartgen.stages.metrics._distances import kernel
from apartgen.stages.metrics._networks import Network
from apartgen.stages.metrics._seen import between


def compare(homes: Sequence[Layout], real: Sequence[Layout], network: Network) -> list[Value]:
    """Versions: generated = generated rooms from half of the real ones · real = the other half from it."""
    return between("KID", kernel, homes, real, network)
