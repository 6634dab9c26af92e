"""Writing a file so that it is either complete or not there, and a sentence where it cannot be."""

from __future__ import annotations

import os
import tempfile
from pathlib import Path

from seacruise.errors import InputError


def check_target(path: Path, what: str) -> None:
    """Refuse a target that cannot be written before hours of sailing are computed for it.

    Parameters
    ----------
    what
        The file as the sentence names it, e.g. ``"chart"``.

    Raises
    ------
    InputError
        The folder is missing or closed to us, or the target is itself a folder.
    """
    try:
        _check_target(path, what)
    except OSError as error:
        raise _not_written(path, what, f"{_reason(error)}; choose another place") from error


def _check_target(path: Path, what: str) -> None:
    folder = path.absolute().parent
    if path.is_dir():
        raise _not_written(path, what, "that is a folder; add a file name")
    if _is_device(path):
        return
    if not folder.is_dir():
        raise _not_written(path, what, f"there is no folder {folder}; create it first")
    if not os.access(folder, os.W_OK):
        raise _not_written(path, what, f"the folder {folder} is write-protected; choose another")


def write_atomically(path: Path, content: str | bytes, *, what: str) -> None:
    """Write a whole file: into a temporary neighbour first, which then takes the name.

    Whatever goes wrong, a file of that name from before stays as it was. A link is followed, and a device
    or pipe such as ``/dev/stdout`` is written into, never replaced.

    Parameters
    ----------
    content
        Text is written as UTF-8 with its line ends as they are.
    what
        The file as a sentence names it, e.g. ``"GPX file"``.

    Raises
    ------
    InputError
        The target cannot be written; the sentence says why.
    """
    check_target(path, what)
    data = content.encode("utf-8") if isinstance(content, str) else content
    target = path.resolve() if path.is_symlink() else path
    temporary: Path | None = None
    try:
        if _is_device(target):
            target.write_bytes(data)
            return
        with tempfile.NamedTemporaryFile(
            dir=target.absolute().parent, prefix=f".{target.name}.", suffix=".part", delete=False
        ) as file:
            temporary = Path(file.name)
            file.write(data)
            file.flush()
            os.fsync(file.fileno())
        # Temporary files are private; an export is as readable as any new file of this user.
        temporary.chmod(_mode_for(target))
        temporary.replace(target)
    except OSError as error:
        if temporary is not None:
            temporary.unlink(missing_ok=True)
        raise _not_written(
            path, what, f"{_reason(error)}; choose another place or make room there"
        ) from error


def _not_written(path: Path, what: str, why: str) -> InputError:
    return InputError(f"The {what} cannot be written to {path}: {why}.", reason="not-written")


def _reason(error: OSError) -> str:
    return (error.strerror or str(error)).lower()


def _is_device(path: Path) -> bool:
    return path.exists() and not path.is_file() and not path.is_dir()


def _mode_for(path: Path) -> int:
    """Permissions of the file that is replaced, or of a new one under the user's umask."""
    if path.exists():
        return path.stat().st_mode & 0o777
    # The mask can only be read by setting it; 0o022 is put back at once.
    mask = os.umask(0o022)
    os.umask(mask)
    return 0o666 & ~mask
