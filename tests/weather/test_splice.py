"""Where two models are put together: found, measured, told once."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from seacruise.weather.splice import Splice, describe_splices, find_splices
from seacruise.weather.wind import from_direction

TIME = 1_795_219_200.0 + 3600.0 * np.arange(48.0)


def steady(turn_at: int | None = None, by_deg: float = 0.0) -> tuple[Any, Any]:
    """Make a wind of 8 m/s that backs a degree an hour, and jumps at one of them."""
    direction = 180.0 - np.arange(48.0)
    if turn_at is not None:
        direction[turn_at:] += by_deg
    return from_direction(8.0, direction)


def names(*stretches: tuple[str, int]) -> list[frozenset[str]]:
    return [frozenset(name.split()) for name, count in stretches for _ in range(count)]


def found(wind: Any, behind: list[frozenset[str]], told: list[frozenset[str]] | None = None) -> Any:
    return find_splices(TIME, wind, behind, told or behind)


def test_one_model_has_no_splice() -> None:
    assert found(steady(), names(("ecmwf", 48))) == ()
    assert found(steady(), [frozenset()] * 48) == ()


def test_a_change_of_the_model_is_a_splice_with_the_jump_of_the_wind() -> None:
    # as recorded in 2021: 42 degrees within an hour
    (splice,) = found(steady(20, 42.0), names(("icon", 20), ("noaa", 28)))
    assert (splice.time, splice.before, splice.after) == (TIME[20], "icon", "noaa")
    assert splice.jump == pytest.approx(2 * 8.0 * np.sin(np.radians(41.0 / 2)), rel=1e-6)
    (smooth,) = found(steady(), names(("icon", 20), ("noaa", 28)))
    assert smooth.jump == 0.0


def test_models_that_agree_by_chance_are_no_splice() -> None:
    assert found(steady(), names(("ecmwf", 10), ("ecmwf noaa", 5), ("ecmwf", 33))) == ()
    (splice,) = found(steady(), names(("ecmwf", 10), ("ecmwf noaa", 5), ("noaa", 33)))
    assert (splice.before, splice.after) == ("ecmwf", "noaa")


def test_a_model_that_stands_in_for_an_hour_is_no_splice() -> None:
    assert found(steady(), names(("sg", 10), ("noaa", 1), ("sg", 9), ("noaa", 2), ("sg", 26))) == ()


def test_the_end_of_a_model_is_a_splice_only_where_the_wind_jumps() -> None:
    told = names(("sg ecmwf noaa", 30), ("sg noaa", 18))
    unknown = [frozenset[str]()] * 48
    assert found(steady(), unknown, told) == ()
    (splice,) = found(steady(30, 40.0), unknown, told)
    assert (splice.time, splice.before, splice.after) == (TIME[30], "ecmwf", "")
    # a model that comes back has not ended
    back = names(("sg ecmwf noaa", 30), ("sg noaa", 5), ("sg ecmwf noaa", 13))
    assert found(steady(30, 40.0), unknown, back) == ()


def test_splices_of_all_places_are_told_once_with_the_greatest_jump() -> None:
    six = 1_795_219_200.0 + 6 * 86400
    splices = [Splice(six, "ecmwf", "noaa", jump) for jump in (0.0, 2.4, 3.14)]
    assert describe_splices("Storm Glass", splices) == [
        "Storm Glass follows ecmwf until 27 Nov 00:00 UTC, then noaa; the wind jumps there by up to 3.1 m/s."
    ]
    assert describe_splices("Storm Glass", [Splice(six, "ecmwf", "noaa"), Splice(six, "dwd", "", 2.0)]) == [
        "Storm Glass loses dwd at 27 Nov 00:00 UTC; the wind jumps there by up to 2.0 m/s.",
        "Storm Glass follows ecmwf until 27 Nov 00:00 UTC, then noaa.",
    ]
