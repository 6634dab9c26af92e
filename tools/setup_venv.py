"""Make ``.venv`` ready: ``python tools/setup_venv.py [dev] [bench]``, with any Python from 3.11.

Creates the environment, installs SeaCruise in it as an editable package with the versions of
``constraints.txt``, checks that Qt finds its system libraries and compiles the kernels once. A stamp in
``.venv`` makes the next call instant. Only the standard library is used, and whatever package index the
machine is configured for.
"""

from __future__ import annotations

import hashlib
import json
import os
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
VENV = ROOT / ".venv"
PYTHON = VENV / ("Scripts/python.exe" if os.name == "nt" else "bin/python")
STAMP = VENV / "seacruise-ready.json"
OLDEST = (3, 11)


class SetupError(Exception):
    """The environment cannot be made ready; the sentence says what to do."""


def stamp_key() -> str:
    """Fingerprint of everything that decides what is in the environment."""
    digest = hashlib.sha256(str(ROOT).encode())
    for name in ("pyproject.toml", "constraints.txt", "tools/setup_venv.py"):
        digest.update((ROOT / name).read_bytes())
    return digest.hexdigest()


def installed_extras() -> set[str] | None:
    """Extras of the environment when it is up to date, else ``None``."""
    try:
        stamp = json.loads(STAMP.read_text(encoding="utf-8"))
        return set(stamp["extras"]) if stamp["key"] == stamp_key() and PYTHON.exists() else None
    except (OSError, ValueError, KeyError, TypeError):
        return None


def venv_is_sound() -> bool:
    """Tell whether the environment has a working Python, new enough, with pip in it."""
    probe = f"import sys, pip; sys.exit(sys.version_info < {OLDEST})"
    try:
        return subprocess.run([str(PYTHON), "-c", probe], capture_output=True, check=False).returncode == 0
    except OSError:
        return False


def create_venv() -> None:
    """Create ``.venv`` afresh with the Python that runs this."""
    try:
        import ensurepip  # noqa: F401 - Debian splits it off, and venv fails late and vaguely without
        import venv
    except ImportError as error:
        package = f"python{sys.version_info[0]}.{sys.version_info[1]}-venv"
        raise SetupError(
            f"{sys.executable} comes without the module {error.name}, which makes virtual environments; "
            f"on Debian or Ubuntu install it with: apt-get install {package}"
        ) from None
    print(f"Creating .venv with Python {sys.version.split()[0]} ...", flush=True)
    venv.EnvBuilder(with_pip=True, clear=True, symlinks=os.name != "nt").create(VENV)


def run(*arguments: str) -> None:
    """Run the environment's Python; what it prints is the user's to read."""
    # A user-wide PIP_USER=1 is refused inside an environment, so it is switched off for this call.
    environment = {**os.environ, "PIP_USER": "0", "PIP_DISABLE_PIP_VERSION_CHECK": "1"}
    code = subprocess.run([str(PYTHON), *arguments], cwd=ROOT, env=environment, check=False).returncode
    if code:
        shown = " ".join(arguments[:3])
        raise SetupError(f"'python {shown}' failed with exit code {code}; what it printed above says why")


def check_qt() -> None:
    """Say by name which system library Qt misses; the command line works without it, so that is all."""
    probe = "from seacruise.commands.window import qt_trouble; print(qt_trouble() or '', end='')"
    found = subprocess.run([str(PYTHON), "-c", probe], capture_output=True, text=True, check=False)
    if said := (found.stdout or found.stderr).strip():
        print(f"NOTE: {said.splitlines()[-1]}", file=sys.stderr)


def make_ready(wanted: set[str]) -> None:
    """Bring the environment up to date with the wanted extras."""
    have = installed_extras()
    if have is not None and wanted <= have:
        return
    if not venv_is_sound():
        create_venv()
    extras = sorted(wanted | (have or set()))
    target = f".[{','.join(extras)}]" if extras else "."
    print(
        f"Installing SeaCruise and what it needs in .venv ({', '.join(extras) or 'program'}) ...", flush=True
    )
    run("-m", "pip", "install", "--quiet", "--editable", target, "--constraint", "constraints.txt")
    check_qt()
    run("-m", "seacruise.warmup")
    STAMP.write_text(json.dumps({"key": stamp_key(), "extras": extras}), encoding="utf-8")


def main(arguments: list[str]) -> int:
    """Make ready; with ``--check`` only tell, by the exit code, whether it is."""
    if sys.version_info < OLDEST:
        print(f"SeaCruise needs Python 3.11 or newer; this is {sys.version.split()[0]}.", file=sys.stderr)
        return 2
    wanted = {a for a in arguments if not a.startswith("-")}
    if "--check" in arguments:
        have = installed_extras()
        return 0 if have is not None and wanted <= have else 1
    try:
        make_ready(wanted)
    except (SetupError, OSError, subprocess.SubprocessError) as error:
        print(f"Set-up stopped: {error}.", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
