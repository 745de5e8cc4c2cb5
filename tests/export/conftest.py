"""Small pictures: what is tested does not depend on their size."""

import pytest


@pytest.fixture(autouse=True, scope="session")
def _small_pictures():
    from stages.export import _render

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(_render, "PIXELS", 30_000)
        yield
