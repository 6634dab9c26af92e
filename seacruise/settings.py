"""Where SeaCruise keeps its files and which servers it talks to: one object, passed in, never global."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path

from seacruise.keychain import STORM_GLASS, KeyChain

STORMGLASS_URL = "https://api.stormglass.io"
OPENMETEO_URL = "https://api.open-meteo.com"
METNO_URL = "https://api.met.no"


def typed_path(text: str) -> Path:
    """Path that a person typed; ``~`` is the home folder, and stays as it is where there is no such home."""
    path = Path(text)
    try:
        return path.expanduser()
    except RuntimeError:
        return path


@dataclass(frozen=True, slots=True)
class Settings:
    """Folders, service addresses, the Storm Glass key and whom a service may write to.

    Attributes
    ----------
    cache_dir
        Things that can be made again: rasters of the sea, compiled lattices.
    data_dir
        Things that are the sailor's: ``seacruise.sqlite``, ``polars/``, ``layers/``.
    stormglass_key
        The bare key, or ``None``; excluded from ``repr`` so that no log can show it.
    contact
        E-mail address or site of who asks, or empty; told to MET Norway alone, which wants it.
    keys
        Where a key may be kept besides; only asked by `with_key`.
    """

    cache_dir: Path
    data_dir: Path
    stormglass_url: str = STORMGLASS_URL
    openmeteo_url: str = OPENMETEO_URL
    metno_url: str = METNO_URL
    stormglass_key: str | None = None
    contact: str = ""
    keys: KeyChain | None = field(default=None, compare=False)

    def __repr__(self) -> str:
        return f"Settings(cache_dir={str(self.cache_dir)!r}, data_dir={str(self.data_dir)!r})"

    @property
    def database(self) -> Path:
        """The one SQLite file: forecast cache, quota ledger, saved passages."""
        return self.data_dir / "seacruise.sqlite"

    @property
    def user_polars(self) -> Path:
        """Folder in which the sailor drops polar files of their own."""
        return self.data_dir / "polars"

    @property
    def layers(self) -> Path:
        """Folder in which the sailor drops GeoJSON files of zones to keep out of."""
        return self.data_dir / "layers"

    def with_key(self) -> Settings:
        """Look for the Storm Glass key in the system's keychain where the environment has none.

        That may ask the sailor to unlock it, and so is only done when Storm Glass is about to be used.
        """
        if self.stormglass_key or self.keys is None:
            return self
        return replace(self, stormglass_key=self.keys.get(STORM_GLASS))

    @classmethod
    def from_environment(cls, environ: Mapping[str, str] | None = None) -> Settings:
        """Read ``SEACRUISE_HOME``, ``SEACRUISE_*_URL``, ``SEACRUISE_CONTACT`` and ``STORMGLASS_API_KEY``."""
        env = os.environ if environ is None else environ
        if home := env.get("SEACRUISE_HOME", "").strip():
            root = typed_path(home)
            cache_dir, data_dir = root / "cache", root / "data"
        else:
            import platformdirs

            cache_dir = platformdirs.user_cache_path("seacruise", appauthor=False)
            data_dir = platformdirs.user_data_path("seacruise", appauthor=False)
        return cls(
            cache_dir=cache_dir,
            data_dir=data_dir,
            stormglass_url=env.get("SEACRUISE_STORMGLASS_URL", STORMGLASS_URL).rstrip("/"),
            openmeteo_url=env.get("SEACRUISE_OPENMETEO_URL", OPENMETEO_URL).rstrip("/"),
            metno_url=env.get("SEACRUISE_METNO_URL", METNO_URL).rstrip("/"),
            stormglass_key=env.get("STORMGLASS_API_KEY", "").strip() or None,
            contact=env.get("SEACRUISE_CONTACT", "").strip(),
            keys=KeyChain(),
        )
