"""Runs a command and prints its wall time and peak memory as JSON; see `measure.run_process`.

A program on its own, of the standard library alone: it must be small and start at once.
"""

from __future__ import annotations

import json
import subprocess
import sys
import tempfile
import time


def main(command: list[str]) -> None:
    """Run, wait, report."""
    with tempfile.TemporaryFile() as output, tempfile.TemporaryFile() as said:
        begun, clock = time.time(), time.perf_counter()
        child = subprocess.Popen(command, stdout=output, stderr=said, stdin=subprocess.DEVNULL)
        code, peak_mb = _wait(child)
        seconds = time.perf_counter() - clock
        texts = []
        for stream in (output, said):
            stream.seek(0)
            texts.append(stream.read().decode("utf-8", errors="replace"))
    report = {
        "seconds": seconds,
        "begun": begun,
        "peak_mb": peak_mb,
        "code": code,
        "output": texts[0],
        "said": texts[1],
    }
    sys.stdout.reconfigure(encoding="utf-8")  # type: ignore[union-attr]
    print(json.dumps(report))


def _wait(child: subprocess.Popen[bytes]) -> tuple[int, float | None]:
    """Wait for a process; its exit code and, where the system tells it, its peak memory [MB]."""
    if sys.platform == "win32":
        return child.wait(), None
    import os

    _, status, usage = os.wait4(child.pid, 0)
    child.returncode = os.waitstatus_to_exitcode(status)
    # Linux counts in KiB, macOS in bytes.
    unit = 1 if sys.platform == "darwin" else 1024
    return child.returncode, usage.ru_maxrss * unit / 1e6


if __name__ == "__main__":
    main(sys.argv[1:])
