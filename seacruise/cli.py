"""The command line: ``plan``, ``compare``, ``reach``, ``replan``, ``window``, ...; alone, the window.

Nothing heavy is imported here, so that ``--help`` answers at once; each sub-command loads what it needs.
"""

from __future__ import annotations

import argparse
import gc
import os
import re
import sys
import threading
from collections.abc import Sequence
from io import TextIOWrapper
from itertools import pairwise

import seacruise
from seacruise.commands import compare, plan, polar, ports, reach, replan, simulate, weather, window
from seacruise.commands.common import Parser, say
from seacruise.errors import CancelledError, NoPassageError, SeaCruiseError

_POSITION_FOLLOWS = {"--from", "--to", "--at"}


def build_parser() -> argparse.ArgumentParser:
    """Make the parser with all sub-commands."""
    parser = Parser(
        prog="seacruise",
        description="How long will it take under sail, and is a week enough?",
        epilog="Without a command the window opens. A planning aid, not for navigation.",
    )
    parser.add_argument("--version", action="version", version=f"SeaCruise {seacruise.__version__}")
    commands = parser.add_subparsers(dest="command", metavar="COMMAND")
    for command in (plan, compare, reach, replan, simulate, window, polar, weather, ports):
        command.add_parser(commands)
    return parser


def main(argv: Sequence[str] | None = None) -> int:
    """Run the command line and return the exit code; no error leaves it as a traceback.

    Returns
    -------
    int
        0 found; 2 bad input; 3 no passage; 4 the weather service failed; 130 cancelled; 1 an error of
        SeaCruise itself.
    """
    words = list(sys.argv[1:] if argv is None else argv) or ["window"]
    _have_streams()
    _speak_utf8()
    if argv is None:
        # A process of its own that ends in a second or two: collecting garbage would cost a tenth of it.
        # So it would of opening the window, which takes its garbage into its own hands once it is painted.
        gc.disable()
    try:
        code = _run(words)
        sys.stdout.flush()
    except BrokenPipeError:
        # The reader had enough (seacruise ports list | head). Python would complain at exit otherwise.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 0
    if argv is None:
        _leave_workers(code)
    return code


def _leave_workers(code: int) -> None:
    """End the process at once where a worker is left that nobody waits for any more.

    Python would end its thread in the midst of compiled code, where that may end the process with a crash.
    """
    if any(thread.daemon for thread in threading.enumerate()):
        import logging

        logging.shutdown()
        sys.stderr.flush()
        os._exit(code)


def _run(words: list[str]) -> int:
    try:
        return _dispatch(words)
    except SeaCruiseError as error:
        return _report(error, words)
    except KeyboardInterrupt:
        return _report(CancelledError(), words)
    except BrokenPipeError:
        raise
    except Exception as error:  # noqa: BLE001 - the promise is that nobody ever sees a traceback
        return _report(_own_error(error), words)


def _dispatch(words: list[str]) -> int:
    parser = build_parser()
    arguments = parser.parse_args(_guard_southern_latitudes(words))
    if arguments.command is None:
        parser.error("a command is missing: plan, compare, reach, replan, window, polar, weather or ports")
    return int(arguments.run(arguments))


def _guard_southern_latitudes(words: list[str]) -> list[str]:
    """Join ``--from -33.9,18.4`` into one word; argparse would take the position for an option."""
    joined: list[str] = []
    for word in words:
        if joined and joined[-1] in _POSITION_FOLLOWS and re.match(r"-[\d.]", word):
            joined[-1] += f"={word}"
        else:
            joined.append(word)
    return joined


def _wants_json(words: list[str]) -> bool:
    return "--format=json" in words or ("--format", "json") in pairwise(words)


def _report(error: SeaCruiseError, words: list[str]) -> int:
    """One sentence on standard error, the reason as JSON on standard output if asked for; the exit code."""
    say(f"seacruise: {error}")
    if _wants_json(words):
        from seacruise.export.jsonform import dumps

        answer: dict[str, object] = {
            "schema": "seacruise.error/1",
            "reason": error.reason,
            "message": str(error),
        }
        if isinstance(error, NoPassageError) and error.place is not None:
            answer["place"] = {"lat": error.place[0], "lon": error.place[1]}
        print(dumps(answer), flush=True)
    return error.exit_code


def _own_error(error: Exception) -> SeaCruiseError:
    """Turn a mistake of ours into a sentence, and keep its traceback for whoever mends it."""
    import traceback

    from seacruise.atomic import write_atomically
    from seacruise.settings import Settings

    settings = Settings.from_environment()
    # A process that has asked the system's keychain may show what it found there.
    settings = settings.with_key() if "keyring" in sys.modules else settings
    text = "".join(traceback.format_exception(error))
    if settings.stormglass_key:
        text = text.replace(settings.stormglass_key, "(key)")
    kept = settings.cache_dir / "last-error.txt"
    try:
        kept.parent.mkdir(parents=True, exist_ok=True)
        write_atomically(kept, text, what="error report")
        where = f"please report it with the file {kept}"
    except (OSError, SeaCruiseError):
        where = "please report it"
    return SeaCruiseError(
        f"SeaCruise made a mistake of its own ({type(error).__name__}); {where}.", reason="internal"
    )


def _have_streams() -> None:
    """Write into nothing where there is no console: a program of Windows' own kind has no streams at all."""
    for name in ("stdout", "stderr"):
        if getattr(sys, name) is None:
            setattr(sys, name, open(os.devnull, "w", encoding="utf-8"))  # noqa: PTH123, SIM115 - until the end


def _speak_utf8() -> None:
    """Names of ports and degree signs must not fail on a terminal or pipe of another encoding."""
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, TextIOWrapper):
            stream.reconfigure(encoding="utf-8", errors="replace")
