"""SCA: how well a classifier of image features tells generated from real rooms, 50 % is best."""

from collections.abc import Sequence

from apartgen.schemas.layout import Layout
from apartgen.schemas.metrics import Value
from apartgen.stages.metrics._distances import separability
from apartgen.stages.metrics._networks import Network
from apartgen.stages.metrics._seen import between


def compare(homes: Sequence[Layout], real: Sequence[Layout], network: Network) -> list[Value]:
    """Versions: generated = generated rooms from half of the real ones · real = the other half from it."""
    return between("SCA", separability, homes, real, network, "%")
