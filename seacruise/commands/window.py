"""``seacruise window``: the window, with the form filled in; also what ``seacruise`` alone opens."""

from __future__ import annotations

import argparse
import ctypes
import os
import re
import sys
from collections.abc import Mapping
from typing import Any

from seacruise.commands import request as ask
from seacruise.commands.common import add_format, parse_path, parse_size, say
from seacruise.errors import InputError

DEBIAN_PACKAGE = {
    "libEGL.so.1": "libegl1",
    "libGL.so.1": "libgl1",
    "libxkbcommon.so.0": "libxkbcommon0",
    "libfontconfig.so.1": "libfontconfig1",
    "libdbus-1.so.3": "libdbus-1-3",
    "libglib-2.0.so.0": "libglib2.0-0",
    "libgthread-2.0.so.0": "libglib2.0-0",
    "libX11.so.6": "libx11-6",
    "libxcb-cursor.so.0": "libxcb-cursor0",
    "libxcb-icccm.so.4": "libxcb-icccm4",
    "libxcb-keysyms.so.1": "libxcb-keysyms1",
    "libxcb-image.so.0": "libxcb-image0",
    "libxcb-render-util.so.0": "libxcb-render-util0",
    "libxcb-xinerama.so.0": "libxcb-xinerama0",
    "libxkbcommon-x11.so.0": "libxkbcommon-x11-0",
}
"""Where Debian and Ubuntu keep the system libraries that Qt is linked with."""

_FOR_X11 = tuple(name for name in DEBIAN_PACKAGE if name.startswith(("libxcb-", "libxkbcommon-x11")))


def add_parser(commands: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Add the sub-command."""
    parser = commands.add_parser(
        "window",
        help="open the window, with these options filled in",
        description="Open the window with these options filled in.",
    )
    ask.add_voyage(parser, required=False)
    ask.add_yacht(parser, required=False)
    ask.add_search_options(parser)
    picture = parser.add_argument_group("a picture of it")
    picture.add_argument(
        "--screenshot",
        type=parse_path,
        metavar="F.png",
        help="compute, save the picture of the window and leave",
    )
    picture.add_argument("--size", type=parse_size, metavar="WxH", help="size of the window, e.g. 1280x800")
    add_format(parser)
    parser.set_defaults(run=run)


def run(arguments: argparse.Namespace) -> int:
    """Open the window and return its exit code when it is closed."""
    if arguments.screenshot is not None:
        from seacruise.atomic import check_target

        check_target(arguments.screenshot, "screenshot")
    choose_platform(os.environ, picture_only=arguments.screenshot is not None)
    if trouble := qt_trouble():
        raise InputError(trouble, reason="no-window")
    from seacruise.desktop.app import open_window

    code = open_window(prefill(arguments), screenshot=arguments.screenshot, size=arguments.size)
    if arguments.format == "json":
        from seacruise.export.jsonform import dumps

        print(dumps({"screenshot": None if arguments.screenshot is None else str(arguments.screenshot)}))
    elif arguments.screenshot is not None and code == 0:
        say(f"Wrote {arguments.screenshot}")
    return code


def prefill(arguments: argparse.Namespace) -> Mapping[str, Any]:
    """Give the options that were said.

    Keys are ``start``, ``end``, ``depart``, ``yacht``, ``forecast`` and the fields of
    `seacruise.passage.Options`.
    """
    aside = {"run", "format", "screenshot", "size", "command"}
    return {name: value for name, value in vars(arguments).items() if value is not None and name not in aside}


def choose_platform(environ: Any, *, picture_only: bool) -> None:
    """Draw in memory where only a picture is wanted and there is no display.

    Raises
    ------
    InputError
        A window is wanted and there is no display: Qt would abort the process.
    """
    if not sys.platform.startswith("linux") or environ.get("QT_QPA_PLATFORM"):
        return
    if environ.get("DISPLAY") or environ.get("WAYLAND_DISPLAY"):
        return
    if not picture_only:
        raise InputError(
            "There is no display here (neither DISPLAY nor WAYLAND_DISPLAY is set), so no window can open; "
            "use seacruise plan, or seacruise window --screenshot F.png.",
            reason="no-window",
        )
    environ["QT_QPA_PLATFORM"] = "offscreen"


def qt_trouble() -> str | None:
    """Say what Qt misses, and where to get it, before Qt aborts the process; ``None`` if nothing."""
    try:
        from seacruise.desktop.thrift import import_qt_plainly

        import_qt_plainly()
        import seacruise.desktop.app  # noqa: F401 - brings Qt, and with it the system's libraries
    except ImportError as error:
        match = re.search(r"(lib[\w.+-]+\.so[.\d]*): cannot open", str(error))
        if match is None:
            raise
        return f"The window cannot open: {_missing([match.group(1)])}."
    platform = os.environ.get("QT_QPA_PLATFORM", "").partition(":")[0]
    from seacruise.desktop.plugins import has_platform

    if platform and ";" not in platform and not has_platform(platform):
        return f"The window cannot open: Qt knows no platform {platform!r}; unset QT_QPA_PLATFORM."
    on_x11 = sys.platform.startswith("linux") and (
        platform == "xcb"
        or (not platform and os.environ.get("DISPLAY") and not os.environ.get("WAYLAND_DISPLAY"))
    )
    absent = [name for name in _FOR_X11 if not _loads(name)] if on_x11 else []
    if absent:
        return f"The window cannot open: {_missing(absent)}."
    if on_x11 and not _answers():
        return (
            f"The window cannot open: the display {os.environ.get('DISPLAY', '')!r} does not answer; "
            "set DISPLAY to one that does."
        )
    return None


def _answers() -> bool:
    """Whether the X server of ``DISPLAY`` can be reached."""
    try:
        library = ctypes.CDLL("libxcb.so.1")
    except OSError:
        return True
    library.xcb_connect.restype = ctypes.c_void_p
    connection = ctypes.c_void_p(library.xcb_connect(None, None))
    broken = library.xcb_connection_has_error(connection)
    library.xcb_disconnect(connection)
    return not broken


def _missing(libraries: list[str]) -> str:
    packages = " ".join(dict.fromkeys(DEBIAN_PACKAGE[name] for name in libraries if name in DEBIAN_PACKAGE))
    advice = f"; on Debian or Ubuntu: apt-get install {packages}" if packages else "; install it"
    return f"Qt needs the system library {', '.join(libraries)}{advice}"


def _loads(library: str) -> bool:
    try:
        ctypes.CDLL(library)
    except OSError:
        return False
    return True
