"""Keys of weather services: where the system keeps passwords, else in memory until the program ends.

The optional package ``keyring`` speaks to the keychains of Windows, macOS and the Linux desktops. It is
imported when a key is first asked for, since that takes a tenth of a second and may ask the sailor to unlock
the keychain. No key is ever written to a file of ours.
"""

from __future__ import annotations

import logging
import threading
from collections.abc import Callable
from typing import Any, Final, Protocol

log = logging.getLogger(__name__)

STORM_GLASS: Final = "stormglass"
_SERVICE: Final = "seacruise"
_SHOWN: Final = 4


class Vault(Protocol):
    """A backend of ``keyring``, or what a test puts in its place; any exception means that it failed."""

    def get_password(self, service: str, username: str) -> str | None:
        """Look a key up."""
        ...

    def set_password(self, service: str, username: str, password: str) -> None:
        """Keep a key."""
        ...

    def delete_password(self, service: str, username: str) -> None:
        """Forget a key."""
        ...


def system_vault() -> Vault | None:
    """Give the system's own keychain; ``None`` where there is none, or ``keyring`` is not installed.

    Backends of other packages are passed over: some keep passwords in a plain file.
    """
    try:
        import keyring
        from keyring.backends import chainer, fail, null
    except ImportError:
        return None
    try:
        chosen = keyring.get_keyring()
        offered = list(chosen.backends) if isinstance(chosen, chainer.ChainerBackend) else [chosen]
    except Exception as error:  # noqa: BLE001 - backends raise whatever their platforms do
        log.warning("The system's keychain cannot be opened (%s).", type(error).__name__)
        return None
    for backend in offered:
        is_none = isinstance(backend, fail.Keyring | null.Keyring)
        if type(backend).__module__.startswith("keyring.backends.") and not is_none:
            found: Vault = backend
            return found
    return None


def shortened(key: str) -> str:
    """Last four characters of a key, which tell keys apart; short keys are not shown at all."""
    return f"…{key[-_SHOWN:]}" if len(key) >= 3 * _SHOWN else "…"


class KeyChain:
    """Keys by the name of their service.

    Parameters
    ----------
    find_vault
        Gives the system's keychain, or ``None``; called once, when it is first needed.
    """

    def __init__(self, find_vault: Callable[[], Vault | None] = system_vault) -> None:
        self._find_vault = find_vault
        self._vault: Vault | None = None
        self._is_open = False
        # What is known already: the keychain is asked once, and a session's key lives nowhere else.
        self._known: dict[str, str | None] = {}
        self._lasting: set[str] = set()
        # Several loads may want the key at once; the sailor is asked to unlock it once.
        self._lock = threading.RLock()

    def __repr__(self) -> str:
        return "KeyChain()"

    def __reduce__(self) -> tuple[Any, ...]:
        """Travel to other processes without any key."""
        return KeyChain, ()

    def _opened(self) -> Vault | None:
        with self._lock:
            if not self._is_open:
                self._vault, self._is_open = self._find_vault(), True
            return self._vault

    @property
    def has_vault(self) -> bool:
        """Whether keys can outlive the program."""
        return self._opened() is not None

    def is_lasting(self, name: str) -> bool:
        """Whether the key of a service lies in the system's keychain."""
        return name in self._lasting

    def get(self, name: str) -> str | None:
        """Look up the key of a service; ``None`` where there is none, or the keychain stays locked."""
        with self._lock:
            if name not in self._known:
                kept = self._try(lambda vault: vault.get_password(_SERVICE, name))
                self._known[name] = kept.strip() or None if isinstance(kept, str) else None
                if self._known[name]:
                    self._lasting.add(name)
            return self._known[name]

    def put(self, name: str, key: str) -> bool:
        """Keep a key; False when it lives only until the program ends."""

        def keep(vault: Vault) -> bool:
            vault.set_password(_SERVICE, name, key)
            # Some backends say nothing when they keep nothing.
            return vault.get_password(_SERVICE, name) == key

        with self._lock:
            self._known[name] = key
            kept = bool(self._try(keep))
        (self._lasting.add if kept else self._lasting.discard)(name)
        return kept

    def remove(self, name: str) -> bool:
        """Forget a key; False when the system's keychain would not let go of it."""

        def forget(vault: Vault) -> bool:
            if vault.get_password(_SERVICE, name) is not None:
                vault.delete_password(_SERVICE, name)
            return True

        with self._lock:
            self._known[name] = None
            gone = self._opened() is None or bool(self._try(forget))
        if gone:
            self._lasting.discard(name)
        return gone

    def _try(self, use: Callable[[Vault], object]) -> object:
        vault = self._opened()
        if vault is None:
            return None
        try:
            return use(vault)
        except Exception as error:  # noqa: BLE001 - backends raise whatever their platforms do
            # Never the error's own text: it may hold what was to be kept.
            log.warning("The system's keychain failed (%s).", type(error).__name__)
            return None
