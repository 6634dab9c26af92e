"""The sea of the Baltic, drawn once for all tests of a session."""

from __future__ import annotations

import pytest

from seacruise.sea import Sea
from tests.routing.worlds import cache_dir_of


@pytest.fixture(scope="session")
def baltic(tmp_path_factory: pytest.TempPathFactory) -> Sea:
    """All of the Baltic on the fine coast."""
    return Sea.around(
        (57.0,), (18.0,), margin_deg=1.0, cache_dir=cache_dir_of(tmp_path_factory.getbasetemp())
    )
