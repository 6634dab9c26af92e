"""Keys of services: kept by the system, else for this session; shown nowhere, written nowhere."""

from __future__ import annotations

import logging
import pickle
import sys
import types
from collections.abc import Iterator
from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path

import pytest

from seacruise import cli
from seacruise.keychain import STORM_GLASS, KeyChain, shortened, system_vault
from seacruise.progress import Job
from seacruise.settings import Settings
from seacruise.weather.cache import Memory
from seacruise.weather.keytest import PLACE, try_key
from seacruise.weather.source import weather_info
from tests.faultserver import FaultServer

KEY = "4d1f-SECRET-8a2c-0123456789"
NOW = datetime(2026, 11, 21, 9, 30, tzinfo=UTC)


class Vault:
    """A keychain in memory that can break, and be told apart from the real ones."""

    def __init__(self, *, broken: bool = False) -> None:
        self.kept: dict[tuple[str, str], str] = {}
        self.broken = broken
        self.asked = 0

    def get_password(self, service: str, username: str) -> str | None:
        self.asked += 1
        if self.broken:
            raise OSError(f"locked: {self.kept}")
        return self.kept.get((service, username))

    def set_password(self, service: str, username: str, password: str) -> None:
        if self.broken:
            raise OSError(password)
        self.kept[service, username] = password

    def delete_password(self, service: str, username: str) -> None:
        del self.kept[service, username]


@pytest.fixture(autouse=True)
def secret_logs(caplog: pytest.LogCaptureFixture) -> Iterator[None]:
    caplog.set_level(logging.DEBUG)
    yield
    assert "SECRET" not in caplog.text


def assert_key_in_no_file(folder: Path) -> None:
    for path in folder.rglob("*"):
        assert not path.is_file() or KEY.encode() not in path.read_bytes(), path


def test_a_key_outlives_the_program_where_there_is_a_keychain() -> None:
    vault = Vault()
    first = KeyChain(lambda: vault)
    assert first.get(STORM_GLASS) is None
    assert first.put(STORM_GLASS, KEY)
    again = KeyChain(lambda: vault)
    assert again.get(STORM_GLASS) == KEY
    assert again.is_lasting(STORM_GLASS)
    assert again.remove(STORM_GLASS)
    assert again.get(STORM_GLASS) is None
    assert KeyChain(lambda: vault).get(STORM_GLASS) is None


@pytest.mark.parametrize("vault", [None, Vault(broken=True)])
def test_without_one_it_lives_for_the_session(vault: Vault | None) -> None:
    keys = KeyChain(lambda: vault)
    assert not keys.put(STORM_GLASS, KEY)
    assert keys.get(STORM_GLASS) == KEY
    assert not keys.is_lasting(STORM_GLASS)
    assert keys.remove(STORM_GLASS) is (vault is None)
    assert keys.get(STORM_GLASS) is None


def test_the_keychain_is_asked_once_and_only_when_a_key_is_wanted() -> None:
    vault, opened = Vault(), []

    def find() -> Vault:
        opened.append(1)
        return vault

    keys = KeyChain(find)
    settings = replace(Settings.from_environment(), keys=keys)
    assert not opened
    for _ in range(3):
        assert settings.with_key().stormglass_key is None
    assert (len(opened), vault.asked) == (1, 1)


def test_the_environment_comes_first(monkeypatch: pytest.MonkeyPatch) -> None:
    vault = Vault()
    keys = KeyChain(lambda: vault)
    keys.put(STORM_GLASS, KEY)
    monkeypatch.setenv("STORMGLASS_API_KEY", "of-the-environment")
    assert replace(Settings.from_environment(), keys=keys).with_key().stormglass_key == "of-the-environment"
    monkeypatch.setenv("STORMGLASS_API_KEY", " ")
    assert replace(Settings.from_environment(), keys=keys).with_key().stormglass_key == KEY


def test_a_key_shows_nowhere_and_does_not_travel() -> None:
    keys = KeyChain(lambda: None)
    keys.put(STORM_GLASS, KEY)
    settings = replace(Settings.from_environment(), keys=keys)
    assert "SECRET" not in repr(keys) + repr(settings) + str(settings.with_key())
    assert b"SECRET" not in pickle.dumps(settings)
    assert pickle.loads(pickle.dumps(keys)).get("another service") is None
    assert shortened(KEY) == "…6789"
    assert shortened("short") == "…"


def test_sources_know_the_kept_key(settings: Settings) -> None:
    keys = KeyChain(lambda: None)
    keys.put(STORM_GLASS, KEY)
    info = weather_info(replace(settings, keys=keys), NOW)
    assert info.quota is not None
    assert next(one for one in info.sources if one.name == "stormglass").usable
    assert "Storm Glass" in info.sources[0].remark


# ------------------------------------------------------------------------------- keyring, when there is


@pytest.fixture
def keyring(monkeypatch: pytest.MonkeyPatch) -> types.ModuleType:
    """Install a package of that name whose backend is the test's."""

    def module(name: str, **names: object) -> types.ModuleType:
        made = types.ModuleType(name)
        for key, value in names.items():
            setattr(made, key, value)
        monkeypatch.setitem(sys.modules, name, made)
        return made

    class Chainer:
        def __init__(self, *backends: object) -> None:
            self.backends = backends

    nothing = type("Keyring", (), {"__module__": "keyring.backends.fail"})
    fail = module("keyring.backends.fail", Keyring=nothing)
    null = module("keyring.backends.null", Keyring=type("Keyring", (), {}))
    chainer = module("keyring.backends.chainer", ChainerBackend=Chainer)
    backends = module("keyring.backends", fail=fail, null=null, chainer=chainer)
    return module("keyring", get_keyring=nothing, backends=backends)


class SystemVault(Vault):
    __module__ = "keyring.backends.SecretService"


class PlainFile(Vault):
    __module__ = "keyrings.alt.file"


def test_the_systems_keychain_is_found_behind_others(keyring: types.ModuleType) -> None:
    good, chain = SystemVault(), keyring.backends.chainer.ChainerBackend
    keyring.get_keyring = lambda: good  # type: ignore[attr-defined]
    assert system_vault() is good
    keyring.get_keyring = lambda: chain(PlainFile(), good)  # type: ignore[attr-defined]
    assert system_vault() is good


def test_no_plain_file_and_nothing_at_all(keyring: types.ModuleType) -> None:
    assert system_vault() is None
    keyring.get_keyring = PlainFile  # type: ignore[attr-defined]
    assert system_vault() is None

    def broken() -> None:
        raise RuntimeError(KEY)

    keyring.get_keyring = broken  # type: ignore[attr-defined]
    assert system_vault() is None


def test_the_command_line_uses_the_kept_key(
    keyring: types.ModuleType, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch,
    tmp_path: Path,
) -> None:  # fmt: skip
    vault = SystemVault()
    vault.kept["seacruise", "stormglass"] = KEY
    keyring.get_keyring = lambda: vault  # type: ignore[attr-defined]
    words = ["weather", "fetch", "--from", "Gdynia", "--to", "Visby", "--forecast", "stormglass"]
    with FaultServer("good") as server:
        monkeypatch.setenv("SEACRUISE_STORMGLASS_URL", server.url)
        assert cli.main(words) == 0
        assert {request.headers["authorization"] for request in server.requests} == {KEY}
    out = capsys.readouterr()
    assert "Storm Glass" in out.out
    assert "SECRET" not in out.out + out.err
    assert_key_in_no_file(tmp_path)


# ------------------------------------------------------------------------------------- testing a key


@pytest.mark.parametrize(
    ("behaviour", "reason"), [("401", "bad-key"), ("402", "quota"), ("500", "bad-response")]
)
def test_a_key_that_fails_the_test_has_a_reason(settings: Settings, behaviour: str, reason: str) -> None:
    from seacruise.errors import WeatherError

    with FaultServer(behaviour) as server:
        asked = replace(settings, stormglass_key=KEY, stormglass_url=server.url)
        with pytest.raises(WeatherError) as caught:
            try_key(asked, now=NOW, job=Job())
        assert len(server.requests) == 1
    assert caught.value.reason == reason
    assert "SECRET" not in str(caught.value)


def test_a_test_is_one_request_and_is_counted(settings: Settings, tmp_path: Path) -> None:
    with FaultServer("good") as server:
        asked = replace(settings, stormglass_key=KEY, stormglass_url=server.url)
        quota = try_key(asked, now=NOW, job=Job())
        (request,) = server.requests
    assert (request.query["lat"], request.query["lng"]) == (f"{PLACE[0]:.3f}", f"{PLACE[1]:.3f}")
    assert (quota.used, quota.daily, quota.known) == (1, 10, True)
    assert Memory(settings.database).quota(KEY, NOW) == quota
    assert_key_in_no_file(tmp_path)
