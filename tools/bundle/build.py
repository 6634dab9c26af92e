"""Build the bundle in ``build/bundle/seacruise``: ``python tools/bundle/build.py``; see docs/bundle.md.

PyInstaller collects (``seacruise.spec`` says what), debug symbols go, compiled kernels and licences come in.
"""

from __future__ import annotations

import os
import re
import shutil
import struct
import subprocess
import sys
import tempfile
from bisect import bisect_left
from collections.abc import Iterator
from importlib import metadata
from pathlib import Path
from typing import Final

ROOT: Final = Path(__file__).resolve().parents[2]
BUNDLE: Final = ROOT / "build" / "bundle" / "seacruise"

_WORTH_IT: Final = 500_000
_HEADER: Final = struct.Struct("<16s2HI3QI6H")
_SEGMENT: Final = struct.Struct("<2I6Q")
_LOAD: Final = 1

# Besides what the package asks for: with it the sailor's key stays in the system's keychain.
_ROOTS: Final = ("seacruise", "keyring")
_LICENCE: Final = re.compile(r"(?i)/(licen[cs]e|copying|notice|authors)[^/]*$|/licen[cs]es/[^/]+$")


def collect() -> None:
    """Let PyInstaller gather the program, its libraries and its data."""
    command = [sys.executable, "-m", "PyInstaller", "--noconfirm", "--log-level", "WARN"]
    folders = ["--distpath", str(BUNDLE.parent), "--workpath", str(ROOT / "build" / "bundle-work")]
    subprocess.run([*command, *folders, str(ROOT / "tools" / "bundle" / "seacruise.spec")], check=True)


def lighten() -> None:
    """Take out of Linux libraries what is never loaded, which is debug symbols mostly."""
    for library in (BUNDLE / "_internal").rglob("*.so*"):
        if library.is_symlink() or not library.is_file():
            continue
        whole = library.read_bytes()
        loaded = only_what_is_loaded(whole)
        if len(whole) - len(loaded) > _WORTH_IT:
            library.write_bytes(loaded)


def only_what_is_loaded(library: bytes) -> bytes:
    """Cut an ELF library down to the segments that the loader maps; other files come back as they are.

    `strip` would do, but what auditwheel has edited no longer loads after it ("not page-aligned"). Here whole
    pages go, so that each segment keeps its place within a page; the table of sections goes with them.
    Source: System V ABI, chapters 4 and 5.
    """
    if not library.startswith(b"\x7fELF\x02\x01"):
        return library
    header = list(_HEADER.unpack_from(library))
    first, count = header[5], header[10]
    places = [first + number * _SEGMENT.size for number in range(count)]
    segments = [list(_SEGMENT.unpack_from(library, place)) for place in places]
    page = max(segment[7] for segment in segments if segment[0] == _LOAD)
    kept = {page * number for number in range(-(-(first + count * _SEGMENT.size) // page))}
    for _, _, offset, _, _, size, _, _ in segments:
        kept.update(range(offset // page * page, offset + size, page))
    order = sorted(kept)
    cut = bytearray(b"".join(library[start : start + page] for start in order))

    def moved(offset: int) -> int:
        return int(bisect_left(order, offset // page * page) * page + offset % page)

    for place, segment in zip(places, segments, strict=True):
        segment[2] = moved(segment[2])
        _SEGMENT.pack_into(cut, moved(place), *segment)
    # No table of sections any more: its place, its length and the number of the one with the names.
    header[5], header[6], header[12], header[13] = moved(first), 0, 0, 0
    _HEADER.pack_into(cut, 0, *header)
    return bytes(cut)


def add_kernels() -> None:
    """Let the bundle compile its kernels and put them into it, so that the first passage need not wait.

    `seacruise.compiled` takes them where the processor is of that kind.
    """
    program = BUNDLE / ("seacruise.exe" if os.name == "nt" else "seacruise")
    with tempfile.TemporaryDirectory() as home:
        env = {**os.environ, "SEACRUISE_HOME": home}
        subprocess.run([str(program), "-m", "seacruise.warmup"], check=True, env=env)
        kernels = Path(home) / "cache" / "kernels"
        shutil.make_archive(str(BUNDLE / "_internal" / "kernels"), "zip", kernels, "bundle")


def distributions() -> list[metadata.Distribution]:
    """Give SeaCruise, PyInstaller (whose bootloader is the program's first page) and all that they need."""
    found: dict[str, metadata.Distribution] = {}
    waiting = [*_ROOTS, "pyinstaller"]
    while waiting:
        name = re.sub(r"[-_.]+", "-", waiting.pop()).lower()
        if name in found:
            continue
        try:
            found[name] = metadata.distribution(name)
        except metadata.PackageNotFoundError:
            # Asked for on another system only.
            continue
        needs = (need for need in found[name].requires or () if "extra ==" not in need)
        waiting += [match[0] for need in needs if (match := re.match(r"[\w.-]+", need))]
    return [found[name] for name in sorted(found)]


def _licences(distribution: metadata.Distribution) -> Iterator[Path]:
    for file in distribution.files or ():
        if ".dist-info/" in file.as_posix() and _LICENCE.search(file.as_posix()):
            yield Path(str(distribution.locate_file(file)))


def add_licences() -> None:
    """Put the licence of each package into ``licenses/``, with a list of the packages."""
    target = BUNDLE / "licenses"
    for name in ("LICENSE", "NOTICE"):
        shutil.copy(ROOT / name, BUNDLE / name)
    lines = ["What this bundle contains besides SeaCruise (LICENSE, NOTICE), and under which licence.\n"]
    for distribution in distributions():
        about = distribution.metadata
        name, terms = about["Name"], (about["License-Expression"] or about["License"] or "").strip()
        # Some packages put the whole text into that field.
        known = terms if terms not in {"", "UNKNOWN"} and "\n" not in terms else "see its files here"
        lines.append(f"{name} {distribution.version}: {known}")
        for file in _licences(distribution):
            folder = target / name
            folder.mkdir(parents=True, exist_ok=True)
            shutil.copy(file, folder / file.name)
    target.mkdir(exist_ok=True)
    (target / "README.txt").write_text("\n".join(lines) + "\n", encoding="utf-8")


def size_mb() -> float:
    """Size of the bundle on disk [MB of 10^6 bytes]; a link counts nothing."""
    files = (path for path in BUNDLE.rglob("*") if path.is_file() and not path.is_symlink())
    return sum(path.stat().st_size for path in files) / 1e6


def main() -> int:
    """Build, and say what came of it."""
    collect()
    lighten()
    add_kernels()
    add_licences()
    print(f"{BUNDLE.relative_to(ROOT)}: {size_mb():.0f} MB")
    return 0


if __name__ == "__main__":
    sys.exit(main())
