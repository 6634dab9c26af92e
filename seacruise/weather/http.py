"""One request to a weather service: bounded in time and size, repeated where that helps, keeping the key.

Traps that this module exists for, all met in requests 2.34 and urllib3 2.8: a read timeout counts per
packet, so a dripping server holds a call for ever; a body cut off in the middle is not retried; a
``Retry-After`` is obeyed for up to six hours; ``.netrc`` replaces a header that was set by hand; an
exception carries the request with its headers, and so the key, into every log that prints it.
"""

from __future__ import annotations

import contextlib
import logging
import os
import random
import socket
import ssl
import threading
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from datetime import UTC, datetime
from email.utils import parsedate_to_datetime
from importlib import metadata
from typing import Final, Generic, TypeVar
from urllib.parse import urlsplit
from urllib.request import getproxies, proxy_bypass

import msgspec
import requests
import urllib3

from seacruise.errors import WeatherError

T = TypeVar("T")

_log = logging.getLogger(__name__)

_CHUNK: Final = 65536
_POLL_S: Final = 0.05
_OVERLOADED: Final = frozenset({500, 502, 503, 504})

_CERTIFICATE: Final = {
    10: "its certificate has expired",
    18: "its certificate is self-signed",
    19: "its certificate is signed by nobody this computer trusts",
    20: "its certificate is signed by nobody this computer trusts",
    62: "its certificate is for another name",
    64: "its certificate is for another address",
}
"""What OpenSSL's verification codes mean to a sailor (``X509_V_ERR_...`` in ``x509_vfy.h``)."""


@dataclass(frozen=True, slots=True)
class Limits:
    """How long and how much; fields, so that tests can shorten them.

    Attributes
    ----------
    connect_s, read_s
        Timeouts of making the connection and of each packet [s].
    total_s
        Deadline of a request with its repetitions, body included [s].
    tries
        Attempts at most; a service that is overloaded or cuts off is asked again.
    backoff_s
        Pause before the second attempt [s], doubled for each one more.
    retry_after_s
        Longest ``Retry-After`` that is waited for [s].
    max_bytes
        Largest body, after decompression.
    """

    connect_s: float = 5.0
    read_s: float = 10.0
    total_s: float = 30.0
    tries: int = 3
    backoff_s: float = 0.5
    retry_after_s: float = 30.0
    max_bytes: int = 5_000_000


@dataclass(frozen=True, slots=True)
class Reply:
    """What came back: enough to judge it, nothing of what was sent.

    Attributes
    ----------
    expires, last_modified
        Headers of these names as they came, or empty.
    """

    status: int
    content_type: str
    retry_after: str
    body: bytes
    expires: str = ""
    last_modified: str = ""


@dataclass(frozen=True, slots=True)
class Call(Generic[T]):
    """A request to make.

    Attributes
    ----------
    service
        Name for sentences, e.g. ``"Storm Glass"``.
    decode
        Makes the answer of a body; a `msgspec.DecodeError` from it counts as a body that was cut off.
    refuse
        The error that a reply of another status means, or ``None`` for those that mean the same everywhere.
    good
        Statuses whose reply is an answer.
    note
        Told of each reply that is an answer, before its body is decoded: for status and headers.
    """

    service: str
    url: str
    params: Mapping[str, str]
    headers: Mapping[str, str]
    decode: Callable[[bytes], T]
    refuse: Callable[[Reply], WeatherError | None]
    good: frozenset[int] = field(default=frozenset({200}))
    note: Callable[[Reply], None] | None = None


@dataclass(frozen=True, slots=True)
class _Failure:
    """Why an attempt failed, whether another one may help, and how long to wait before it [s]."""

    error: WeatherError
    again: bool = False
    wait_s: float = 0.0


def program_name() -> str:
    """Name this program and its version, for services that want to know who asks."""
    try:
        return f"SeaCruise/{metadata.version('seacruise')}"
    except metadata.PackageNotFoundError:
        # run from a checkout that was never installed
        return "SeaCruise/0"


def new_session() -> requests.Session:
    """Make a session that takes proxies and certificates from the environment, and nothing else."""
    session = requests.Session()
    # .netrc would replace the Authorization header; what is wanted of the environment is taken by hand
    session.trust_env = False
    session.verify = os.environ.get("REQUESTS_CA_BUNDLE") or os.environ.get("SSL_CERT_FILE") or True
    session.headers.update(
        {
            "Accept": "application/json",
            "Accept-Encoding": "gzip",
            "User-Agent": program_name(),
        }
    )
    return session


def require_name(service: str, url: str, seconds: float, *, check: Callable[[], None] = lambda: None) -> None:
    """Look up the name of a service's computer, for a limited time.

    The system's own look-up cannot be given a deadline, and on a network that leads nowhere (a harbour's
    before one has signed in) it takes half a minute for each request.

    Parameters
    ----------
    check
        Called every now and then; what it raises ends the waiting.

    Raises
    ------
    WeatherError
        ``no-network`` when the name is not found within ``seconds``.
    """
    host = urlsplit(url).hostname
    if not host or _proxies(url):
        return
    answered = threading.Event()

    def look_up() -> None:
        # a name that does not exist is an answer too; the request itself then says so
        with contextlib.suppress(OSError, UnicodeError):
            socket.getaddrinfo(host, None)
        answered.set()

    threading.Thread(target=look_up, name="weather-name", daemon=True).start()
    end = time.monotonic() + seconds
    while not answered.wait(_POLL_S):
        check()
        if time.monotonic() > end:
            raise unreachable(service)


def fetch(session: requests.Session, call: Call[T], limits: Limits, stop: threading.Event) -> T:
    """Make a request and decode its answer, within the limits.

    Parameters
    ----------
    stop
        Set by a caller that no longer waits; ends pauses at once.

    Raises
    ------
    WeatherError
        With no trace of the request: neither cause nor context.
    """
    deadline = time.monotonic() + limits.total_s
    failure = _Failure(timed_out(call.service, limits.total_s))
    for number in range(limits.tries):
        outcome = _attempt(session, call, limits, deadline)
        if not isinstance(outcome, _Failure):
            return outcome
        failure = outcome
        _log.debug("%s: %s", call.service, failure.error)
        jitter = random.uniform(1.0, 1.3)  # noqa: S311 (spreads repetitions, guards nothing)
        pause = max(failure.wait_s, limits.backoff_s * 2**number * jitter)
        if not failure.again or number + 1 == limits.tries or time.monotonic() + pause >= deadline:
            break
        if stop.wait(pause):
            break
    raise failure.error


def _attempt(session: requests.Session, call: Call[T], limits: Limits, deadline: float) -> T | _Failure:
    """Make one attempt; errors come back as values, for raising one inside an ``except`` would chain it."""
    left = deadline - time.monotonic()
    if left <= 0:
        return _Failure(timed_out(call.service, limits.total_s))
    try:
        with session.get(
            call.url,
            params=call.params,
            headers=call.headers,
            timeout=(min(limits.connect_s, left), min(limits.read_s, left)),
            proxies=_proxies(call.url),
            allow_redirects=False,
            stream=True,
        ) as response:
            body = _read(response, limits, deadline)
            reply = Reply(
                status=response.status_code,
                content_type=response.headers.get("Content-Type", "").split(";")[0].strip().lower(),
                retry_after=response.headers.get("Retry-After", "").strip(),
                body=body if isinstance(body, bytes) else b"",
                expires=response.headers.get("Expires", "").strip(),
                last_modified=response.headers.get("Last-Modified", "").strip(),
            )
        if reply.status in call.good and not isinstance(body, bytes):
            return body if body is not None else _Failure(timed_out(call.service, limits.total_s))
    except (requests.RequestException, urllib3.exceptions.HTTPError, OSError, ValueError) as error:
        return _transport_failure(call, error, limits)
    return _judge(call, reply, limits)


def _read(response: requests.Response, limits: Limits, deadline: float) -> bytes | _Failure | None:
    """Read a body packet by packet; ``None`` when the deadline passes before its end."""
    parts, size = [], 0
    while part := response.raw.read1(_CHUNK, decode_content=True):
        size += len(part)
        if size > limits.max_bytes:
            return _Failure(
                WeatherError(
                    f"The weather service sent more than {limits.max_bytes // 10**6} MB; that is no forecast."
                )
            )
        if time.monotonic() > deadline:
            return None
        parts.append(part)
    return b"".join(parts)


def _judge(call: Call[T], reply: Reply, limits: Limits) -> T | _Failure:
    """Decide what a complete reply means."""
    if reply.status not in call.good:
        error = call.refuse(reply)
        if error is not None:
            return _Failure(error)
        return _status_failure(call.service, reply, limits)
    if reply.body and reply.content_type and "json" not in reply.content_type:
        return _Failure(
            WeatherError(
                f"Something else answered in place of {call.service} (a page, not data): a hotel or harbour "
                "network may want you to sign in first; open a web page, then try again."
            )
        )
    try:
        if call.note is not None:
            call.note(reply)
        return call.decode(reply.body)
    except msgspec.ValidationError as error:
        # the message names the place in the document and the kind of value, not the value
        what = str(error)
    except (msgspec.DecodeError, RecursionError, UnicodeDecodeError):
        return _Failure(
            WeatherError(f"{call.service} sent an answer that is incomplete or not JSON; try again later."),
            again=True,
        )
    return _Failure(WeatherError(f"{call.service} sent an answer of another shape than expected ({what})."))


def _status_failure(service: str, reply: Reply, limits: Limits) -> _Failure:
    if reply.status == 429:
        wait_s = _retry_after(reply.retry_after)
        when = (
            "in some minutes"
            if wait_s <= 0
            else f"in {wait_s / 60:.0f} minutes"
            if wait_s > 90
            else "in a minute"
        )
        return _Failure(
            WeatherError(f"{service} is asked too often just now; try again {when}.", reason="quota"),
            again=wait_s <= limits.retry_after_s,
            wait_s=wait_s,
        )
    if reply.status in _OVERLOADED:
        return _Failure(
            WeatherError(f"{service} has trouble of its own (HTTP {reply.status}); try again later."),
            again=True,
        )
    if 300 <= reply.status < 400:
        return _Failure(
            WeatherError(
                f"{service} sent the request on to another address, which is not followed: a network may "
                "want you to sign in first, or the service's address in the environment is wrong."
            )
        )
    if reply.status == 407:
        return _Failure(
            WeatherError(
                "The proxy of this network asks for a password; set it in HTTPS_PROXY.", reason="no-network"
            )
        )
    return _Failure(
        WeatherError(
            f"{service} gave an answer that is not a forecast (HTTP {reply.status}); check its address."
        )
    )


def _retry_after(text: str) -> float:
    """Seconds that a ``Retry-After`` asks for: a number or a date; 0 when it says nothing."""
    if text.isascii() and text.isdigit():
        return float(text[:9])
    try:
        when = parsedate_to_datetime(text)
    except ValueError:
        return 0.0
    aware = when if when.tzinfo else when.replace(tzinfo=UTC)
    return max((aware - datetime.now(UTC)).total_seconds(), 0.0)


def _transport_failure(call: Call[T], error: Exception, limits: Limits) -> _Failure:
    """Say in one sentence what went wrong between here and there; never the exception's own text."""
    service = call.service
    causes = tuple(_causes(error))
    if any(isinstance(cause, requests.exceptions.SSLError) for cause in causes):
        return _Failure(
            WeatherError(
                f"{service} could not prove who it is ({_certificate_fault(causes)}), so nothing was sent; "
                "check this computer's date, or use another network."
            )
        )
    if isinstance(error, requests.exceptions.ProxyError):
        return _Failure(
            WeatherError("The proxy of this network does not answer; check HTTPS_PROXY.", reason="no-network")
        )
    # before timeouts, for urllib3 makes a refused connection a kind of timeout
    lost = (socket.gaierror, ConnectionRefusedError, urllib3.exceptions.NewConnectionError)
    if any(isinstance(cause, lost) for cause in causes):
        return _Failure(unreachable(service))
    if isinstance(error, requests.exceptions.ConnectTimeout):
        # whoever does not even pick up will not do so a second later
        return _Failure(timed_out(service, limits.connect_s))
    timeouts = (requests.exceptions.Timeout, urllib3.exceptions.TimeoutError, TimeoutError)
    if any(isinstance(cause, timeouts) for cause in causes):
        return _Failure(timed_out(service, limits.total_s), again=True)
    if isinstance(error, ValueError):
        return _Failure(WeatherError(f"The address or the key of {service} in the environment is not valid."))
    if type(error) is OSError and "certificate" in str(error):
        return _Failure(
            WeatherError("The file in REQUESTS_CA_BUNDLE or SSL_CERT_FILE does not exist; correct it.")
        )
    return _Failure(
        WeatherError(f"The connection to {service} broke off in the middle of an answer; try again."),
        again=True,
    )


def _causes(error: BaseException) -> list[BaseException]:
    """List an exception and what it was made of: requests wraps urllib3, which wraps the system's."""
    found: list[BaseException] = []
    waiting: list[object] = [error]
    while waiting:
        one = waiting.pop()
        if isinstance(one, BaseException) and one not in found:
            found.append(one)
            waiting += [one.__cause__, one.__context__, getattr(one, "reason", None), *one.args]
    return found


def _certificate_fault(causes: Sequence[BaseException]) -> str:
    codes = [cause.verify_code for cause in causes if isinstance(cause, ssl.SSLCertVerificationError)]
    return _CERTIFICATE.get(codes[0], "its certificate is not valid") if codes else "no safe TLS connection"


def unreachable(service: str) -> WeatherError:
    """Make the error of a service that no connection leads to."""
    return WeatherError(
        f"{service} cannot be reached; check the internet connection, or plan with practice weather.",
        reason="no-network",
    )


def timed_out(service: str, seconds: float) -> WeatherError:
    """Make the error of a service that did not answer in time [s]."""
    return WeatherError(
        f"{service} did not answer within {seconds:g} seconds; try again, or plan with practice weather.",
        reason="timeout",
    )


def _proxies(url: str) -> dict[str, str]:
    """Proxies of the environment or the system, unless they are to be passed by for this host."""
    host = urlsplit(url).hostname or ""
    return {} if host in ("127.0.0.1", "localhost", "::1") or proxy_bypass(host) else dict(getproxies())
