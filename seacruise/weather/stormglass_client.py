"""One answer of Storm Glass: how it is asked for, and what its refusals mean."""

from __future__ import annotations

import re
import threading
import weakref
from collections.abc import Callable
from typing import Final

import msgspec
import requests

from seacruise.errors import WeatherError
from seacruise.settings import Settings
from seacruise.weather.answers import Meta, decode_answer, decode_meta, to_point
from seacruise.weather.http import Call, Limits, Reply, fetch, new_session
from seacruise.weather.point import PointAnswer

SERVICE: Final = "Storm Glass"
PARAMS: Final = "currentDirection,currentSpeed,gust,waveHeight,windDirection,windSpeed"
"""Asked together: one value costs as much as all of them."""

_PATH: Final = "/v2/weather/point"


def check_key(settings: Settings) -> str:
    """Return the key, or say what is wrong with it.

    Raises
    ------
    WeatherError
        ``no-key`` or ``bad-key``.
    """
    key = (settings.stormglass_key or "").strip()
    if not key:
        raise WeatherError(
            "Storm Glass needs a key: set STORMGLASS_API_KEY to yours (a free one is at stormglass.io), or "
            "plan with practice weather or a file.",
            reason="no-key",
        )
    # a line break would start a header of its own
    if not re.fullmatch(r"[\x21-\x7e]{1,200}", key):
        raise WeatherError(
            "The key in STORMGLASS_API_KEY has characters that no key has; copy it again without spaces.",
            reason="bad-key",
        )
    return key


def quota_error(left: int = 0) -> WeatherError:
    """Make the error of a day's requests that are used up, or too few."""
    what = "has no request left" if left <= 0 else f"has only {left} left"
    return WeatherError(
        f"Storm Glass {what} for today; the quota resets at 00:00 UTC. Until then plan with practice weather "
        "or a file.",
        reason="quota",
    )


class _Sessions:
    """Connections to an address that all clients of this process share; closed when the last one leaves."""

    def __init__(self) -> None:
        self._idle: list[requests.Session] = []
        self._clients = 0
        self._lock = threading.Lock()

    def join(self) -> None:
        with self._lock:
            self._clients += 1

    def part(self) -> None:
        with self._lock:
            self._clients -= 1
            idle, self._idle = ([], self._idle) if self._clients else (self._idle, [])
        for session in idle:
            session.close()

    def take(self) -> requests.Session:
        # a session is no thread's own, but never used by two at a time
        with self._lock:
            return self._idle.pop() if self._idle else new_session()

    def give_back(self, session: requests.Session, *, keep: bool) -> None:
        with self._lock:
            if keep and self._clients:
                self._idle.append(session)
                return
        session.close()


_shared: weakref.WeakValueDictionary[str, _Sessions] = weakref.WeakValueDictionary()
_shared_lock = threading.Lock()


def _sessions_to(url: str) -> _Sessions:
    with _shared_lock:
        found = _shared.get(url)
        if found is None:
            found = _shared[url] = _Sessions()
        return found


class Client:
    """Asks Storm Glass for one place at a time; may be used by several threads.

    Parameters
    ----------
    on_meta
        Told what each answer says about the quota, from the thread that asks.
    """

    def __init__(self, settings: Settings, limits: Limits, on_meta: Callable[[Meta], None]) -> None:
        self._url = settings.stormglass_url + _PATH
        self._key = check_key(settings)
        self._limits = limits
        self._on_meta = on_meta
        self._sessions = _sessions_to(self._url)
        self._sessions.join()

    def ask(
        self, place: tuple[float, float], window: tuple[float, float], *, source: str, stop: threading.Event
    ) -> PointAnswer:
        """Get the wind at a place.

        Parameters
        ----------
        place
            Latitude and longitude [degrees].
        window
            First and last time [s since 1970].
        source
            Preferred model, or several joined by ``+``. All are asked for, so that another can stand in
            where they have no value.
        stop
            Set when nobody waits any more.

        Raises
        ------
        WeatherError
        """
        call = Call(
            service=SERVICE,
            url=self._url,
            params={
                "lat": f"{place[0]:.3f}",
                "lng": f"{place[1]:.3f}",
                "params": PARAMS,
                "start": f"{window[0]:.0f}",
                "end": f"{window[1]:.0f}",
            },
            headers={"Authorization": self._key},
            decode=decode_answer,
            refuse=self._refusal,
        )
        session = self._sessions.take()
        try:
            answer = fetch(session, call, self._limits, stop)
        finally:
            self._sessions.give_back(session, keep=not stop.is_set())
        self._on_meta(answer.meta)
        return to_point(answer, place=place, window=window, source=source)

    def close(self) -> None:
        """Let go of the connections; those still waiting for a lost answer close after it."""
        self._sessions.part()

    def _refusal(self, reply: Reply) -> WeatherError | None:
        """Say what the service's own error codes mean; ``None`` for those that mean the same everywhere."""
        if reply.status == 402:
            daily = decode_meta(reply.body).daily
            self._on_meta(Meta(used=daily, daily=daily, spent=True))
            return quota_error()
        if reply.status in (401, 403):
            return WeatherError(
                "Storm Glass does not accept the key; correct STORMGLASS_API_KEY (see your page there).",
                reason="bad-key",
            )
        if reply.status == 422:
            return WeatherError(
                f"Storm Glass does not understand the request: {_named_parameters(reply.body)}."
            )
        return None


def _named_parameters(body: bytes) -> str:
    """Names of the parameters that a 422 complains about; never its free text, which may echo anything."""
    try:
        document = msgspec.json.decode(body, type=dict[str, object])
        errors = document.get("errors")
        names = (
            [name for name in errors if re.fullmatch(r"[A-Za-z]{1,20}", str(name))]
            if isinstance(errors, dict)
            else []
        )
    except (msgspec.DecodeError, RecursionError, UnicodeDecodeError):
        names = []
    return f"it names the parameter {', '.join(names[:5])}" if names else "it does not say why"
