"""What all tests share: no network, nothing of the real user, Qt without a screen, the real data."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from hypothesis import HealthCheck
from hypothesis import settings as hypothesis_settings

from seacruise.passage import Passage
from seacruise.settings import Settings
from tests.network import NETWORK
from tests.passages import hand_made_passage
from tests.routing.worlds import cache_dir_of

# Before anything imports Qt: windows of tests are drawn in memory.
os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

REPOSITORY = Path(__file__).resolve().parent.parent
SHARED_DATA = REPOSITORY.parent / "shared" / "data"

# A deadline would be a timed assert: the first example may compile a kernel.
hypothesis_settings.register_profile("default", deadline=None, max_examples=60)
hypothesis_settings.register_profile(
    "nightly", deadline=None, max_examples=20_000, suppress_health_check=[HealthCheck.too_slow]
)
hypothesis_settings.load_profile(os.environ.get("HYPOTHESIS_PROFILE", "default"))


def pytest_configure() -> None:
    NETWORK.install()


def pytest_unconfigure() -> None:
    NETWORK.remove()


@pytest.fixture(autouse=True)
def no_network() -> Iterator[None]:
    """Fail a test that tries to leave this machine, even when the program survived it."""
    NETWORK.attempts.clear()
    yield
    assert not NETWORK.attempts, f"a test tried to reach {', '.join(NETWORK.attempts)}"


@pytest.fixture(autouse=True)
def own_home(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """Keep tests off the real user's files, keys and quota."""
    monkeypatch.setenv("SEACRUISE_HOME", str(tmp_path / "home"))
    for name in (
        "STORMGLASS_API_KEY",
        "SEACRUISE_CONTACT",
        "http_proxy",
        "https_proxy",
        "HTTP_PROXY",
        "HTTPS_PROXY",
    ):
        monkeypatch.delenv(name, raising=False)
    for name in ("SEACRUISE_STORMGLASS_URL", "SEACRUISE_OPENMETEO_URL", "SEACRUISE_METNO_URL"):
        # Port 9 is "discard"; nothing listens there, so an unexpected request is refused at once.
        monkeypatch.setenv(name, "http://127.0.0.1:9")


@pytest.fixture
def settings(own_home: None) -> Settings:
    """Folders under the test's own temporary folder and servers that refuse."""
    return Settings.from_environment()


@pytest.fixture(scope="session")
def sea_settings(tmp_path_factory: pytest.TempPathFactory) -> Settings:
    """Folders of which the sea is kept, and all else is as new."""
    base = tmp_path_factory.getbasetemp()
    return Settings(cache_dir=cache_dir_of(base), data_dir=base / "data")


@pytest.fixture(scope="session")
def shared_data() -> Path:
    """Folder of real forecasts, polars, coasts and logs; skips, saying so, where it is absent."""
    if not SHARED_DATA.is_dir():
        pytest.skip(f"REAL DATA ABSENT: no {SHARED_DATA.name}/ beside the checkout (../shared/data)")
    return SHARED_DATA


def pytest_terminal_summary(terminalreporter: Any) -> None:
    """Say aloud how much was not tested for want of the real data."""
    skipped = [r for r in terminalreporter.stats.get("skipped", ()) if "REAL DATA ABSENT" in str(r.longrepr)]
    if skipped:
        terminalreporter.section("not tested")
        terminalreporter.write_line(f"{len(skipped)} tests need ../shared/data, which is not there.")


@pytest.fixture(scope="session")
def passage() -> Passage:
    """A passage made by hand, for everything that shows or writes one."""
    return hand_made_passage()
