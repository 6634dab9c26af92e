"""``seacruise weather``: get a forecast before leaving the network, and see what is stored."""

from __future__ import annotations

import argparse
from datetime import UTC, datetime
from typing import TYPE_CHECKING, Any

from seacruise.commands import request as ask
from seacruise.commands.common import add_format, cancellable_job

if TYPE_CHECKING:
    from seacruise.weather.source import WeatherInfo
    from seacruise.weather.wind import Wind


def add_parser(commands: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Add the sub-command and what it can do."""
    parser = commands.add_parser("weather", help="get a forecast, or see what is stored")
    actions = parser.add_subparsers(dest="action", required=True, metavar="ACTION")
    fetch = actions.add_parser(
        "fetch",
        help="get and store the wind for a passage",
        description="Get the wind for a passage and store it, so that plan works without a network.",
    )
    ask.add_voyage(fetch, required=True)
    add_format(fetch)
    fetch.set_defaults(run=run_fetch)
    info = actions.add_parser("info", help="what is stored, and what is left of the day's quota")
    add_format(info)
    info.set_defaults(run=run_info)


def run_fetch(arguments: argparse.Namespace) -> int:
    """Get the wind and tell what came."""
    from seacruise.settings import Settings

    settings = Settings.from_environment()
    start, end = ask.find_ends(arguments)
    with cancellable_job() as job:
        wind = ask.fetch(arguments, start, end, settings=settings, job=job)
    if arguments.format == "json":
        from seacruise.export.jsonform import dumps

        print(dumps(describe(wind)))
    else:
        from seacruise.export.textform import format_forecast
        from seacruise.weather.contents import carried

        print(format_forecast(wind.forecast, now=datetime.now(UTC)))
        print(f"{wind.time.size} times at {wind.lat.size * wind.lon.size} points, {wind.describe_area()}")
        print(f"With {', '.join(carried(wind)) or 'the wind alone'}")
        if wind.forecast.notice:
            print(f"! {wind.forecast.notice}")
    return 0


def describe(wind: Wind) -> dict[str, Any]:
    """Put what a wind covers into an object: the forecast as in a passage, and the size of the grid."""
    from seacruise.export.jsonform import forecast_to_json
    from seacruise.weather.contents import carried

    return {
        "schema": "seacruise.weather/1",
        "forecast": forecast_to_json(wind.forecast),
        "real": wind.forecast.real,
        "notice": wind.forecast.notice or None,
        "with": carried(wind),
        "members": len(wind.members),
        "times": int(wind.time.size),
        "points": int(wind.lat.size * wind.lon.size),
        "south": float(wind.lat[0]),
        "north": float(wind.lat[-1]),
        "west": float(wind.lon[0]),
        "east": float(wind.lon[-1]),
    }


def run_info(arguments: argparse.Namespace) -> int:
    """Tell which sources can be used, what is stored and what is left of the quota; nothing is sent."""
    from seacruise.settings import Settings
    from seacruise.weather.source import weather_info

    settings = Settings.from_environment()
    info = weather_info(settings)
    if arguments.format == "json":
        from seacruise.export.jsonform import dumps

        print(dumps({**info_to_json(info), "polars": str(settings.user_polars)}))
    else:
        print(info_to_text(info))
        print(f"Your polars: {settings.user_polars}")
    return 0


def info_to_json(info: WeatherInfo) -> dict[str, Any]:
    """Put what is known about sources, store and quota into an object."""
    quota = info.quota
    return {
        "schema": "seacruise.weather-info/1",
        "sources": [
            {"name": s.name, "usable": s.usable, "remark": s.remark, "terms": s.terms or None}
            for s in info.sources
        ],
        "quota": None if quota is None else {"left": quota.left, "daily": quota.daily, "known": quota.known},
        "cached": [{"service": c.service, "place": c.place, "age_h": round(c.age_h, 2)} for c in info.cached],
        "database": str(info.database),
        "database_bytes": info.database_bytes,
        "trouble": info.trouble or None,
    }


def info_to_text(info: WeatherInfo) -> str:
    """Say which sources can be used, what is stored, and where."""
    lines = ["Sources"]
    for source in info.sources:
        lines.append(f"  {source.name:<19} {'' if source.usable else 'not now: '}{source.remark}")
        lines += [f"  {'':<19} {source.terms}"] if source.terms else []
    lines += ["", f"Stored answers: {len(info.cached)}"]
    lines += [f"  {c.service}  {c.place}  {c.age_h:.1f} h old" for c in info.cached]
    lines.append(f"File: {info.database}, {info.database_bytes / 1000:.0f} kB")
    return "\n".join([*lines, *([f"! {info.trouble}"] if info.trouble else [])])
