"""One export of the sample flat for each format, with small pictures: what is tested does not depend on their size."""

import pytest
from export import sample

from stages import export


@pytest.fixture(autouse=True, scope="session")
def _small_pictures():
    from stages.export import _render

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(_render, "PIXELS", 30_000)
        yield


@pytest.fixture(scope="session")
def exported(tmp_path_factory):
    def folder(name: str):
        """The folder of the sample flat in that format."""
        out = tmp_path_factory.mktemp(name) / "scene"
        export.run(sample.home(), [name], out, sample.load)
        return out

    return folder
