"""A service that cannot prove who it is gets nothing and gives nothing: certificates made for the test."""

from __future__ import annotations

import os
import shutil
import ssl
import subprocess
import warnings
from collections.abc import Callable
from dataclasses import dataclass, replace
from datetime import UTC, datetime
from pathlib import Path

import pytest

from seacruise.errors import WeatherError
from seacruise.progress import Job
from seacruise.settings import Settings
from seacruise.weather.metno import MetNo, MetNoConfig
from seacruise.weather.openmeteo import OpenMeteo, OpenMeteoConfig
from seacruise.weather.stormglass import StormGlass
from seacruise.weather.wind import Wind
from tests.faultserver import FaultServer
from tests.weather.weatherserver import met_norway, open_meteo

NOW = datetime(2026, 11, 21, 9, 30, tzinfo=UTC)
BOX = (54.0, 17.0, 56.0, 19.0)

# `openssl ca` takes dates in the past on every version; `openssl x509 -days` does not
CONFIG = """
[req]
distinguished_name = name
prompt = no
x509_extensions = authority
[name]
CN = {name}
[authority]
basicConstraints = critical, CA:TRUE
keyUsage = critical, keyCertSign, digitalSignature
subjectKeyIdentifier = hash
[ca]
default_ca = here
[here]
database = index.txt
serial = serial
new_certs_dir = .
default_md = sha256
policy = any
unique_subject = no
[any]
commonName = supplied
[own]
subjectAltName = IP:127.0.0.1, DNS:localhost
[other]
subjectAltName = DNS:weather.example
"""


@dataclass(frozen=True)
class Certificates:
    """A folder with an authority, ``ca.pem``, and servers' certificates with the key ``server.key``."""

    folder: Path

    def run(self, *arguments: str, name: str = "test") -> None:
        (self.folder / "test.cnf").write_text(CONFIG.format(name=name))
        subprocess.run(
            ["openssl", *arguments],
            cwd=self.folder,
            check=True,
            capture_output=True,
            env={**os.environ, "OPENSSL_CONF": "test.cnf"},
        )

    def sign(self, name: str, *, years: tuple[int, int], names: str) -> None:
        begin, end = (f"{year}0101000000Z" for year in years)
        self.run(
            *("ca", "-batch", "-notext", "-config", "test.cnf", "-cert", "ca.pem", "-keyfile", "ca.key"),
            *("-in", "server.csr", "-out", f"{name}.pem", "-startdate", begin, "-enddate", end),
            *("-extensions", names),
        )

    def context(self, name: str) -> ssl.SSLContext:
        context = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
        context.load_cert_chain(self.folder / f"{name}.pem", self.folder / "server.key")
        return context


@pytest.fixture(scope="session")
def certificates(tmp_path_factory: pytest.TempPathFactory) -> Certificates:
    if shutil.which("openssl") is None:
        pytest.skip("TLS NOT TESTED: the program openssl, which makes the certificates, is not installed")
    made = Certificates(tmp_path_factory.mktemp("certificates"))
    (made.folder / "index.txt").write_text("")
    (made.folder / "serial").write_text("01")
    new = ("-config", "test.cnf", "-newkey", "rsa:2048", "-nodes")
    made.run("req", "-x509", *new, "-keyout", "ca.key", "-out", "ca.pem", "-days", "30", name="Authority")
    made.run("req", *new, "-keyout", "server.key", "-out", "server.csr", name="Server")
    made.sign("valid", years=(2020, 2048), names="own")
    made.sign("expired", years=(2020, 2021), names="own")
    made.sign("not-yet", years=(2047, 2048), names="own")
    made.sign("wrong-host", years=(2020, 2048), names="other")
    signed = ("-key", "server.key", "-out", "self-signed.pem", "-days", "30", "-extensions", "own")
    made.run("req", "-x509", "-config", "test.cnf", *signed)
    return made


Fetch = Callable[[Settings, str], Wind]


def fetch_open_meteo(settings: Settings, url: str) -> Wind:
    service = OpenMeteo(replace(settings, openmeteo_url=url), OpenMeteoConfig(max_points=4))
    return service.wind(BOX, departure=None, now=NOW, job=Job())


def fetch_met_norway(settings: Settings, url: str) -> Wind:
    service = MetNo(replace(settings, metno_url=url), MetNoConfig(max_points=4, pace_s=0.0))
    return service.wind(BOX, departure=None, now=NOW, job=Job())


def fetch_storm_glass(settings: Settings, url: str) -> Wind:
    service = StormGlass(replace(settings, stormglass_url=url, stormglass_key="secret"))
    return service.wind(BOX, departure=None, now=NOW, job=Job())


def serve(service: str, context: ssl.SSLContext | None) -> FaultServer:
    if service == "open-meteo":
        return open_meteo(today=NOW.replace(hour=0, minute=0), tls=context)
    return met_norway(now=NOW, tls=context) if service == "metno" else FaultServer(tls=context)


SERVICES: dict[str, tuple[str, Fetch]] = {
    "open-meteo": ("Open-Meteo", fetch_open_meteo),
    "metno": ("MET Norway", fetch_met_norway),
    "stormglass": ("Storm Glass", fetch_storm_glass),
}
FAULTS = [
    ("expired", True, "its certificate has expired"),
    ("not-yet", True, "its certificate is not valid"),
    ("wrong-host", True, "its certificate is for another"),
    ("self-signed", True, "its certificate is self-signed"),
    ("valid", False, "its certificate is signed by nobody this computer trusts"),
]


@pytest.mark.parametrize("service", SERVICES)
@pytest.mark.parametrize(
    ("name", "known", "words"),
    FAULTS,
    ids=[f"B-{case[0]}{'' if case[1] else '-unknown-ca'}" for case in FAULTS],
)
def test_certificate(
    settings: Settings,
    certificates: Certificates,
    monkeypatch: pytest.MonkeyPatch,
    service: str,
    name: str,
    known: bool,
    words: str,
) -> None:
    if known:
        monkeypatch.setenv("REQUESTS_CA_BUNDLE", str(certificates.folder / "ca.pem"))
    title, fetch = SERVICES[service]
    with (
        serve(service, certificates.context(name)) as server,
        pytest.raises(WeatherError, match=words) as caught,
    ):
        fetch(settings, server.url)
    assert str(caught.value).startswith(f"{title} could not prove who it is")
    assert caught.value.reason == "bad-response"
    # not a word was said to it
    assert server.requests == []


@pytest.mark.parametrize("service", SERVICES)
def test_a_service_that_proves_who_it_is_is_used(
    settings: Settings, certificates: Certificates, monkeypatch: pytest.MonkeyPatch, service: str
) -> None:
    monkeypatch.setenv("REQUESTS_CA_BUNDLE", str(certificates.folder / "ca.pem"))
    title, fetch = SERVICES[service]
    with serve(service, certificates.context("valid")) as server:
        wind = fetch(settings, server.url)
    assert wind.forecast.source.startswith(title)


@pytest.mark.parametrize("service", SERVICES)
def test_B_tls_of_the_last_century(  # noqa: N802 (the letter is that of the fault's group)
    settings: Settings, certificates: Certificates, monkeypatch: pytest.MonkeyPatch, service: str
) -> None:
    monkeypatch.setenv("REQUESTS_CA_BUNDLE", str(certificates.folder / "ca.pem"))
    context = certificates.context("valid")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", DeprecationWarning)
        context.minimum_version = ssl.TLSVersion.TLSv1
        context.maximum_version = ssl.TLSVersion.TLSv1
    context.set_ciphers("ALL:@SECLEVEL=0")
    with serve(service, context) as server, pytest.raises(WeatherError, match="no safe TLS") as caught:
        SERVICES[service][1](settings, server.url)
    assert caught.value.reason == "bad-response"
    assert server.requests == []


@pytest.mark.parametrize("service", SERVICES)
def test_B_no_tls_at_all(settings: Settings, service: str) -> None:  # noqa: N802
    with serve(service, None) as server, pytest.raises(WeatherError, match="no safe TLS"):
        SERVICES[service][1](settings, server.url.replace("http:", "https:"))


@pytest.mark.parametrize("service", SERVICES)
def test_B_missing_bundle(  # noqa: N802
    settings: Settings, monkeypatch: pytest.MonkeyPatch, service: str
) -> None:
    monkeypatch.setenv("REQUESTS_CA_BUNDLE", "/nowhere/bundle.pem")
    with pytest.raises(WeatherError, match="REQUESTS_CA_BUNDLE"):
        SERVICES[service][1](settings, "https://127.0.0.1:9")
