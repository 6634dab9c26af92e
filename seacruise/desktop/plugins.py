"""What Qt brings to put windows on a screen: asked before it aborts the process for want of it."""

from __future__ import annotations

import os
import re
from pathlib import Path

from PySide6.QtCore import QLibraryInfo


def has_platform(name: str) -> bool:
    """Whether Qt has the plugin of a platform; where plugins are kept elsewhere, it is for Qt to say.

    Parameters
    ----------
    name
        As in ``QT_QPA_PLATFORM``, e.g. ``"xcb"``, ``"wayland-egl"``.
    """
    folder = Path(QLibraryInfo.path(QLibraryInfo.LibraryPath.PluginsPath)) / "platforms"
    if os.environ.get("QT_QPA_PLATFORM_PLUGIN_PATH") or not folder.is_dir():
        return True
    plain = re.escape(name.partition("-")[0])
    return any(re.fullmatch(rf"(lib)?q{plain}(-\w+)?d?\.\w+", plugin.name) for plugin in folder.iterdir())
