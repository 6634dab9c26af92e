"""No-go zones: wind farms, firing ranges, traffic schemes - for good, or for a time.

A zone is a polygon in (lat, lon) and an interval of time: a prism in (lat, lon, time) that no passage may
enter. Zones come as GeoJSON; properties ``valid_from`` and ``valid_to`` (ISO 8601) bound them in time, and
without them a zone is closed for good. Sides are straight in the Mercator plane.
"""

from __future__ import annotations

import json
import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from functools import cached_property
from pathlib import Path
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from seacruise.errors import InputError
from seacruise.geodesy import to_mercator

Array = NDArray[np.float64]

MARGIN_M: Final = 60.0
MARGIN_S: Final = 300.0
"""Search keeps this far off a zone [m of the plane] and its times [s], so that the last check never finds
a passage inside for the sake of rounding."""

MOST_BYTES: Final = 50_000_000
_NAMES: Final = ("name", "Name", "NAME", "SITENAME", "Full_Name", "title", "id")


@dataclass(frozen=True, slots=True, eq=False)
class Zone:
    """A closed area.

    Attributes
    ----------
    rings
        Each ``(n, 2)`` lon and lat [degrees], closed; inside is what an odd number of them encloses.
    valid_from, valid_to
        Seconds since 1970; infinite for a zone that is closed for good.
    """

    name: str
    rings: tuple[Array, ...]
    valid_from: float = -math.inf
    valid_to: float = math.inf


@dataclass(frozen=True, eq=False)
class Zones:
    """All zones of a passage."""

    zones: tuple[Zone, ...] = ()

    def __bool__(self) -> bool:
        return bool(self.zones)

    @property
    def told(self) -> str:
        """Sentence for the sailor."""
        return f"Zones that are kept clear of: {len(self.zones)}."

    @cached_property
    def arrays(self) -> tuple[NDArray[np.int64], Array, Array, Array]:
        """What the kernels call ``zones``, see `seacruise.sea._prisms.closed`."""
        edges = [_edges(_area(zone).buffer(MARGIN_M, join_style="mitre")) for zone in self.zones]
        first = np.concatenate([[0], np.cumsum([len(e) for e in edges])]).astype(np.int64)
        boxes = [[*e[:, :2].min(axis=0), *e[:, :2].max(axis=0)] if len(e) else [0.0] * 4 for e in edges]
        spans = [[zone.valid_from - MARGIN_S, zone.valid_to + MARGIN_S] for zone in self.zones]
        return (
            first,
            np.concatenate(edges) if edges else np.empty((0, 4)),
            np.array(boxes, dtype=np.float64).reshape(-1, 4),
            np.array(spans, dtype=np.float64).reshape(-1, 2),
        )

    def close(self, lines: Array, begin: Array | float, end: Array | float) -> NDArray[np.bool_]:
        """Tell which ways ``(n, 4)`` of the Mercator plane touch a zone valid at any time they last.

        Parameters
        ----------
        begin, end
            Of each way, or of all [s since 1970].
        """
        from seacruise.sea import _prisms as k

        x0, y0, x1, y1 = (np.ascontiguousarray(c) for c in np.asarray(lines, dtype=np.float64).T)
        out = np.zeros(x0.size, dtype=bool)
        t0, t1 = (np.array(np.broadcast_to(t, out.shape), dtype=np.float64) for t in (begin, end))
        k.closed_many(self.arrays, x0, y0, x1, y1, t0, t1, out)
        return out

    def entered(self, lat: Array, lon: Array, time: Array) -> tuple[str, ...]:
        """Names of the zones that a finely sampled track ``(n,)`` [degrees, s] enters while valid.

        The last check of a passage; by polygons of shapely, it shares nothing with `close`.
        """
        import shapely

        x, y = to_mercator(lat, lon)
        steps = np.stack([np.stack([x[:-1], y[:-1]], axis=1), np.stack([x[1:], y[1:]], axis=1)], axis=1)
        lines = shapely.linestrings(steps)
        found = []
        for zone in self.zones:
            during = (time[1:] >= zone.valid_from) & (time[:-1] <= zone.valid_to)
            area = shapely.Polygon()
            for ring in zone.rings:
                rx, ry = to_mercator(ring[:, 1], ring[:, 0])
                area = area.symmetric_difference(
                    shapely.make_valid(shapely.Polygon(np.stack([rx, ry], axis=1)))
                )
            if bool((shapely.intersects(area, lines) & during).any()):
                found.append(zone.name)
        return tuple(found)


def _area(zone: Zone) -> Any:
    """Zone as a polygon of the Mercator plane [m]."""
    import shapely

    area = shapely.Polygon()
    for ring in zone.rings:
        x, y = to_mercator(ring[:, 1], ring[:, 0])
        area = area.symmetric_difference(shapely.make_valid(shapely.Polygon(np.stack([x, y], axis=1))))
    return area


def _edges(area: Any) -> Array:
    """Sides ``(n, 4)`` of all rings of a polygon."""
    import shapely

    rings = [shapely.get_coordinates(ring) for ring in shapely.get_rings(shapely.get_parts(area))]
    return np.concatenate([np.hstack([ring[:-1], ring[1:]]) for ring in rings] or [np.empty((0, 4))])


def load_zones(paths: Iterable[Path]) -> Zones:
    """Read zones from GeoJSON files.

    Raises
    ------
    InputError
        Naming file and feature, when one cannot be read.
    """
    return Zones(tuple(zone for path in paths for zone in _read(Path(path))))


def layer_files(folder: Path) -> list[Path]:
    """GeoJSON files that the sailor has put into the folder of layers, by name."""
    try:
        return sorted(p for p in folder.iterdir() if p.suffix.lower() in {".geojson", ".json"})
    except OSError:
        return []


def _read(path: Path) -> Iterator[Zone]:
    try:
        size = path.stat().st_size
        content = json.loads(path.read_text(encoding="utf-8-sig") if size <= MOST_BYTES else "")
    except OSError as error:
        raise InputError(f"The zone file {path} cannot be read: {error.strerror or error}.") from None
    except (ValueError, RecursionError):
        raise InputError(
            f"The zone file {path} is not GeoJSON of up to {MOST_BYTES // 10**6} MB; export the zones so."
        ) from None
    features = _features(content)
    if features is None:
        raise InputError(f"The zone file {path} holds no GeoJSON features; export the zones as GeoJSON.")
    for number, feature in enumerate(features, start=1):
        where = f"feature {number} of {path.name}"
        rings = tuple(_rings(feature.get("geometry"), where))
        if rings:
            properties = feature.get("properties") or {}
            yield Zone(
                _name(properties, where),
                rings,
                _time(properties, "valid_from", -math.inf, where),
                _time(properties, "valid_to", math.inf, where),
            )


def _features(content: Any) -> list[dict[str, Any]] | None:
    if not isinstance(content, dict):
        return None
    if content.get("type") == "FeatureCollection":
        found = content.get("features")
        return found if isinstance(found, list) and all(isinstance(f, dict) for f in found) else None
    if content.get("type") == "Feature":
        return [content]
    return [{"geometry": content}] if "coordinates" in content else None


def _rings(geometry: Any, where: str) -> Iterator[Array]:
    """Rings of a Polygon or MultiPolygon; other geometries bound no area and are passed over."""
    kind = geometry.get("type") if isinstance(geometry, dict) else None
    if kind not in {"Polygon", "MultiPolygon"}:
        return
    polygons = [geometry.get("coordinates")] if kind == "Polygon" else geometry.get("coordinates")
    try:
        rings = [np.array([[float(p[0]), float(p[1])] for p in ring]) for one in polygons for ring in one]
    except (TypeError, ValueError, IndexError, KeyError):
        rings = [np.full((1, 2), np.nan)]
    for ring in rings:
        if len(ring) < 3 or not (np.abs(ring) <= (360.0, 90.0)).all():
            raise InputError(f"The polygon of {where} has points that are not longitude and latitude.")
        closed = np.array_equal(ring[0], ring[-1])
        yield ring if closed else np.vstack([ring, ring[:1]])


def _name(properties: dict[str, Any], where: str) -> str:
    for key in _NAMES:
        value = properties.get(key)
        if isinstance(value, str) and value.strip():
            return value.strip()
    return where


def _time(properties: dict[str, Any], key: str, default: float, where: str) -> float:
    value = properties.get(key)
    if value in (None, ""):
        return default
    try:
        moment = datetime.fromisoformat(str(value))
    except ValueError:
        raise InputError(
            f"{key} of {where} is {value!r}, not a time; write it like 2026-07-01T06:00Z."
        ) from None
    return (moment if moment.tzinfo else moment.replace(tzinfo=UTC)).timestamp()


NO_ZONES: Final = Zones()


def blocking(zones: Zones, lat: float, lon: float, time: float) -> Sequence[str]:
    """Names of the zones in which a position [degrees] lies at a time [s since 1970]."""
    return zones.entered(np.array([lat, lat]), np.array([lon, lon + 1e-7]), np.array([time, time]))
