"""Text that people type and files that people send: encodings, numbers, names without diacritics."""

from __future__ import annotations

import difflib
import math
import re
import unicodedata
from collections.abc import Iterable, Mapping
from pathlib import Path

from seacruise.errors import InputError

MAX_BYTES = 5_000_000
"""Largest table that is read; the largest honest one known has 20 kB."""

_NUMBER = re.compile(r"[+-]?(?:[0-9]+(?:[.,][0-9]*)?|[.,][0-9]+)(?:[eE][+-]?[0-9]{1,3})?")

# Letters that are no base letter with an accent, so that Unicode does not take them apart.
_PLAIN = str.maketrans({"ł": "l", "ø": "o", "æ": "ae", "œ": "oe", "đ": "d", "ð": "d", "þ": "th", "ı": "i"})
_WRITTEN_OUT = str.maketrans({"ä": "ae", "ö": "oe", "ü": "ue", "å": "aa", "ø": "oe"})


def read_text(path: Path, what: str) -> str:
    """Read a text file of unknown encoding: UTF-8 or UTF-16, with or without mark, else Windows-1252.

    Parameters
    ----------
    path
        The file.
    what
        What it should be, for the sentence: ``"polar file"``.

    Raises
    ------
    InputError
        It is missing, a folder, unreadable, empty, larger than `MAX_BYTES` or not text.
    """
    try:
        if path.is_dir():
            raise InputError(f"{path} is a folder; name a {what}.")
        if path.stat().st_size > MAX_BYTES:
            raise InputError(f"{path.name} is larger than {MAX_BYTES // 1_000_000} MB; that is no {what}.")
        data = path.read_bytes()
    except FileNotFoundError:
        raise InputError(f"There is no {what} {path}; check the name and the folder.") from None
    except (OSError, ValueError) as error:
        detail = error.strerror if isinstance(error, OSError) and error.strerror else str(error)
        raise InputError(f"The {what} {str(path)!r} cannot be read: {detail}.") from error
    text = _decode(data)
    if text is None or any(unicodedata.category(c) == "Cc" and c not in "\t\n\r\f" for c in set(text)):
        raise InputError(f"{path.name} is not a text file; choose a {what} in text form (CSV).")
    if not text.strip():
        raise InputError(f"{path.name} is empty; choose another {what}.")
    return text


def _decode(data: bytes) -> str | None:
    if data.startswith((b"\xff\xfe", b"\xfe\xff")):
        encodings = ["utf-16"]
    elif b"\0" in data[1:2]:
        encodings = ["utf-16-le"]
    elif b"\0" in data[:1]:
        encodings = ["utf-16-be"]
    else:
        encodings = ["utf-8-sig", "cp1252", "latin-1"]
    for encoding in encodings:
        try:
            return data.decode(encoding)
        except UnicodeDecodeError:
            continue
    return None


def split_lines(text: str) -> list[str]:
    """Lines as an editor numbers them, whether they end in LF, CR LF, CR, or CR CR CR LF."""
    return re.split(r"\r*\n|\r", text)


def parse_number(text: str) -> float | None:
    """Read a number in plain digits, with decimal point or comma; ``None`` for anything else.

    ``float`` would take ``nan``, ``inf``, ``1_000`` and digits of other scripts.
    """
    text = text.strip()
    if not _NUMBER.fullmatch(text):
        return None
    value = float(text.replace(",", "."))
    return value if math.isfinite(value) else None


def fold(text: str) -> str:
    """Reduce a name to what people type: no case, no diacritics, words of letters and digits."""
    return _words(text.casefold().translate(_PLAIN))


def folds(text: str) -> tuple[str, ...]:
    """Ways in which a name is typed on a foreign keyboard: ``Århus`` is ``arhus`` and ``aarhus``."""
    lower = unicodedata.normalize("NFC", text.casefold())
    return tuple(dict.fromkeys((fold(lower), _words(lower.translate(_WRITTEN_OUT).translate(_PLAIN)))))


def same_name(text: str, keys: Iterable[str]) -> bool:
    """Whether what was typed is a name of these `folds`, blanks and hyphens apart: ``X332`` is X-332."""
    squeezed = {key.replace(" ", "") for key in keys}
    return any(key.replace(" ", "") in squeezed for key in folds(text) if key)


def _words(text: str) -> str:
    letters = (c for c in unicodedata.normalize("NFKD", text) if not unicodedata.combining(c))
    return " ".join(re.findall(r"[^\W_]+", "".join(c if c not in "'’`.´" else "" for c in letters)))


def rank_names(text: str, keys: Mapping[str, Iterable[str]]) -> list[str]:
    """Names that fit what is typed so far, best first: whole name, its beginning, a word's, anywhere.

    Parameters
    ----------
    text
        What was typed.
    keys
        Of each name its `folds`.
    """
    typed = folds(text)
    ranked = []
    for place, (name, candidates) in enumerate(keys.items()):
        rank = min((_rank(query, key) for key in candidates for query in typed), default=9)
        if rank < 9:
            ranked.append((rank, place, name))
    return [name for _, _, name in sorted(ranked)]


def _rank(query: str, key: str) -> int:
    if not query or query == key:
        return 0
    if key.startswith(query + " "):
        return 1
    if key.startswith(query):
        return 2
    if f" {query}" in f" {key}":
        return 3
    return 4 if query in key else 9


def suggestions(text: str, keys: Mapping[str, Iterable[str]], *, limit: int = 3) -> list[str]:
    """Names closest to a mistyped one."""
    by_key = {key: name for name, candidates in reversed(list(keys.items())) for key in candidates}
    close = [key for query in folds(text) for key in difflib.get_close_matches(query, by_key, 6, 0.6)]
    return list(dict.fromkeys(by_key[key] for key in close))[:limit]


def did_you_mean(names: list[str]) -> str:
    """End a sentence by offering names, e.g. ``did you mean Gdynia or Gdańsk?``."""
    if len(names) < 2:
        return f"did you mean {names[0]}?" if names else ""
    return f"did you mean {', '.join(names[:-1])} or {names[-1]}?"
