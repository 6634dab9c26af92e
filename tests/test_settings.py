"""Settings: from the environment, without showing the key to anyone."""

from __future__ import annotations

import dataclasses
from pathlib import Path

import pytest

from seacruise.settings import METNO_URL, OPENMETEO_URL, STORMGLASS_URL, Settings

KEY = "0f3a-secret-9b"


def test_one_folder_for_everything(tmp_path: Path) -> None:
    found = Settings.from_environment({"SEACRUISE_HOME": f"  {tmp_path}  "})
    assert found.cache_dir == tmp_path / "cache"
    assert found.data_dir == tmp_path / "data"
    assert found.database.parent == found.user_polars.parent == found.data_dir
    assert found.database.name == "seacruise.sqlite"
    assert list(tmp_path.iterdir()) == [], "reading settings makes no folders"


def test_a_tilde_is_the_home_folder(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("HOME", str(tmp_path))
    monkeypatch.setenv("USERPROFILE", str(tmp_path))
    assert Settings.from_environment({"SEACRUISE_HOME": "~/boat"}).data_dir == tmp_path / "boat" / "data"


def test_without_a_folder_the_platforms_own() -> None:
    found = Settings.from_environment({})
    assert found.cache_dir != found.data_dir
    assert found.cache_dir.is_absolute()
    assert "seacruise" in str(found.cache_dir).lower()
    assert Settings.from_environment({"SEACRUISE_HOME": "   "}) == found


def test_servers_and_their_slashes(tmp_path: Path) -> None:
    home = {"SEACRUISE_HOME": str(tmp_path)}
    usual = Settings.from_environment(home)
    assert (usual.stormglass_url, usual.openmeteo_url, usual.metno_url) == (
        STORMGLASS_URL,
        OPENMETEO_URL,
        METNO_URL,
    )
    assert all(url.startswith("https://") for url in (STORMGLASS_URL, OPENMETEO_URL, METNO_URL))
    own = Settings.from_environment(
        home
        | {
            "SEACRUISE_STORMGLASS_URL": "http://127.0.0.1:8080/",
            "SEACRUISE_OPENMETEO_URL": "http://127.0.0.1:8081//",
            "SEACRUISE_METNO_URL": "http://127.0.0.1:8082",
        }
    )
    assert (own.stormglass_url, own.openmeteo_url, own.metno_url) == (
        "http://127.0.0.1:8080",
        "http://127.0.0.1:8081",
        "http://127.0.0.1:8082",
    )


@pytest.mark.parametrize(("given", "kept"), [(None, None), ("", None), ("  \n", None), (f" {KEY}\n", KEY)])
def test_the_key_is_bare_or_absent(given: str | None, kept: str | None, tmp_path: Path) -> None:
    environ = {"SEACRUISE_HOME": str(tmp_path)} | ({} if given is None else {"STORMGLASS_API_KEY": given})
    assert Settings.from_environment(environ).stormglass_key == kept


def test_nobody_sees_the_key(tmp_path: Path) -> None:
    found = Settings(cache_dir=tmp_path, data_dir=tmp_path, stormglass_key=KEY)
    for shown in (repr(found), str(found), f"{found}", f"{[found]}", f"{ {'settings': found} }"):
        assert KEY not in shown
    with pytest.raises(dataclasses.FrozenInstanceError):
        found.stormglass_key = None  # type: ignore[misc]


def test_the_real_environment_is_the_default(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("SEACRUISE_HOME", str(tmp_path / "elsewhere"))
    assert Settings.from_environment().data_dir == tmp_path / "elsewhere" / "data"
