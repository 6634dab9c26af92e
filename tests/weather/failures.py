"""What goes wrong between us and a weather service, whichever it is, and what must then hold.

The behaviours are those of `tests.faultserver` and `tests.weather.weatherserver`; group A is the way there,
C what a service refuses, D what it sends, E in which shape and unit.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import AbstractContextManager
from datetime import datetime, timedelta
from typing import Final

import numpy as np
import pytest

from seacruise.errors import WeatherError
from seacruise.weather.http import Limits
from seacruise.weather.wind import Wind
from tests.faultserver import FaultServer

NOW: Final[datetime] = datetime.fromisoformat("2026-11-21T09:30:00+00:00")
LATER: Final = NOW + timedelta(hours=7)
BOX: Final = (54.0, 17.0, 56.0, 19.0)

SHORT: Final = Limits(connect_s=2.0, read_s=0.3, total_s=0.8, tries=2, backoff_s=0.01, retry_after_s=0.2)
LATE: Final = {"timeout", "drip", "drip-head"}
"""A slow machine must not turn a late answer into a timeout where the case is another one: these alone have
short limits."""

BROKEN: Final = "trouble of its own"
BAD_JSON: Final = "incomplete or not JSON"
CUT: Final = "broke off"

Case = tuple[str, str, str, str]
"""Group, behaviour of the server, reason of the error, words of its sentence."""


def on_the_way(too_often: str) -> list[Case]:
    """Group A: what HTTP and the network do, whatever is asked.

    Parameters
    ----------
    too_often
        What the service's own refusal of too many requests (429) says.
    """
    table = {
        ("bad-response", "HTTP 404"): ["404"],
        ("no-network", "proxy"): ["407"],
        ("bad-response", "HTTP 410"): ["410"],
        ("quota", too_often): ["429", "429-seconds", "429-date", "429-day", "429-nonsense"],
        ("bad-response", BROKEN): ["500", "502", "503"],
        ("timeout", "did not answer within"): ["timeout", "drip", "drip-head"],
        ("bad-response", CUT): [
            "reset", "hang-up", "reset-body", "truncated", "chunked-short", "not-http", "gzip-corrupt",
        ],
        ("bad-response", BAD_JSON): ["garbage", "empty"],
        ("bad-response", "."): ["gzip-short"],
        ("bad-response", "more than 5 MB"): ["gzip-bomb", "big"],
        ("bad-response", "HTTP 204"): ["204"],
        ("bad-response", "not followed"): ["redirect", "redirect-away", "redirect-loop"],
    }  # fmt: skip
    return [
        ("A", name, reason, words) for (reason, words), behaviours in table.items() for name in behaviours
    ]


def each(names: str, cases: Sequence[tuple[str, ...]]) -> pytest.MarkDecorator:
    """Run a test for each case, named by its group and behaviour; the group is no argument."""
    return pytest.mark.parametrize(
        names.split(), [case[1:] for case in cases], ids=[f"{case[0]}-{case[1]}" for case in cases]
    )


def behaviours(*tables: Sequence[tuple[str, ...]]) -> set[str]:
    return {case[1] for table in tables for case in table}


def fails(server: FaultServer, ask: Callable[[FaultServer], Wind], reason: str, words: str) -> str:
    """Ask a server that fails and return the sentence, which a sailor can read."""
    with server, pytest.raises(WeatherError, match=words) as caught:
        ask(server)
    sentence = str(caught.value)
    assert caught.value.reason == reason
    assert caught.value.exit_code == 4
    assert sentence.endswith(".")
    assert sentence.isprintable()
    assert len(sentence) < 250
    return sentence


def old_answers_serve(
    good: AbstractContextManager[FaultServer],
    bad: AbstractContextManager[FaultServer],
    *,
    before: Callable[[FaultServer], Wind],
    after: Callable[[FaultServer], Wind],
) -> str:
    """Ask while the service is well and again when it fails: the same wind, and the notice of the second."""
    with good as server:
        first = before(server)
    with bad as server:
        second = after(server)
    np.testing.assert_array_equal(first.u, second.u)
    return second.forecast.notice
