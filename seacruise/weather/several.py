"""Several sources asked for one mean: what suffices is used, and what is missing is said."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Final

from seacruise.errors import NoPassageError, SeaCruiseError, WeatherError
from seacruise.weather.blend import blend
from seacruise.weather.wind import Wind

_TITLES: Final = {"stormglass": "Storm Glass", "open-meteo": "Open-Meteo", "metno": "MET Norway"}


def mean_of(
    names: Sequence[str],
    get: Callable[[str], Wind],
    *,
    weights: Sequence[float] | None = None,
    say: Callable[[str], None] = lambda _: None,
) -> Wind:
    """Get the wind of each source and average what came.

    A service that cannot be reached, or does not forecast the day of the departure, is left out of the mean
    as long as any other answers: the mean of two is worth more than none of three. A file that cannot be read
    is not left out: it lies here, and who named it wants to know.

    Parameters
    ----------
    names
        Services and files; a single one is asked for its own wind, and its failure is the answer.
    get
        Gets the wind of a name.
    weights
        One for each name, equal by default; those of sources that are left out go with them.
    say
        Is told at once which source is left out, and why.

    Returns
    -------
    Wind
        See `seacruise.weather.blend.blend`; the notice names what is missing from it.

    Raises
    ------
    WeatherError
        All failed; that of the first.
    NoPassageError
        ``outside-forecast``, where no source failed otherwise.
    InputError
        A file cannot be used, or what came has nothing in common.
    """
    winds: dict[int, Wind] = {}
    failed: dict[int, SeaCruiseError] = {}
    for index, name in enumerate(names):
        try:
            winds[index] = get(name)
        except (WeatherError, NoPassageError) as error:
            if len(names) == 1:
                raise
            failed[index] = error
            say(_without(name, error))
    if not winds:
        raise min(failed.values(), key=lambda error: isinstance(error, NoPassageError))
    left = None if weights is None else [weights[index] for index in winds]
    wind = blend(list(winds.values()), left)
    if not failed:
        return wind
    missing = [_without(names[index], error) for index, error in failed.items()]
    notice = " ".join(filter(None, [*missing, wind.forecast.notice]))
    return replace(wind, forecast=replace(wind.forecast, notice=notice))


def _without(name: str, error: SeaCruiseError) -> str:
    service = _TITLES.get(name.lower().partition(":")[0], name)
    # what follows is advice for those who asked for this source alone
    why = str(error).split(";", maxsplit=1)[0].rstrip(".")
    return f"The mean is without {service}: {why}."
