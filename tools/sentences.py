"""The sentences that the core says, as templates: ``{name} is empty; choose another {what}.`` and so on.

The core speaks plain English and knows nothing of languages. The window translates what it shows at its
border (`seacruise.desktop.language`), by these templates; they are read from the source, not by running it.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Final

# Speaks to a terminal, which stays English.
_ELSEWHERE: Final = "commands"
_NOT_HEARD: Final = frozenset({"cli.py", "__main__.py", "compiled.py", "warmup.py", "__init__.py"})
# Words in pictures, texts and tables of files, and the window's own; what these modules raise is a sentence.
_RAISES_ONLY: Final = re.compile(
    r"(export/|simulation\.py|records\.py|desktop/)(?!pages/weather_model|pages/departures_model).*"
)
_DUMB_CALLS: Final = frozenset(
    {"debug", "info", "warning", "error", "exception", "execute", "compile", "cast", "tr", "translate"}
)
_DUMB_ERRORS: Final = frozenset({"AttributeError", "TypeError", "RuntimeError", "AssertionError"})
_NO_SENTENCE: Final = re.compile(
    r"^\s*(SELECT|INSERT|DELETE|UPDATE|CREATE|DROP|PRAGMA|BEGIN|COMMIT)\b|^f\.id|%s|\(\?|\?\)|"
    r"^[a-z_]+/\d|^(c?m|km|meters?) (s|h|per second)|^(upper|lower) (left|right)$|"
    r"^(offset points|tuple\[.*|unable to open|not a database|has no attribute.*| since )$|"
    r"^(awa|aws|cog|hdm|heading|lat|lon|rpm|sog|stw|time|twa|tws|variation) [a-z ]+$|"
    r"^stormglass |^Settings\(|^module |^vpp,|^sails? \{\}$|^# |/gpx|"
    r"passage planner|^open-meteo \w+$|^; contact|\\W|"
    r"^no array of ours|^\{\}( \{\})? to \{\} \{\}$|^\{\} (UTC|marine)$|^!"
)
_A_WORD: Final = re.compile(r"[^\W\d_]{2,}")

_FILES: Final = ("polar file", "list of ports", "list of points", "list of landmarks")
_TROUBLES: Final = (
    "is damaged; move it away and SeaCruise makes a new one",
    "is in use by another program; close that and try again",
    "cannot be written: the disk is full",
    "cannot be written; set SEACRUISE_HOME to a folder of yours",
    "cannot be used ({})",
)

WORDS: Final = (
    *("wind", "gusts", "gust", "waves", "wave height", "current", "no gusts", "no waves", "members"),
    *("hold", "fade", "refuse", "held", "begins", "ends", "port", "starboard", "both", "and", "has", "have"),
    *("north", "south", "east", "west"),
    *("GPX file", "KML file", "CSV file", "PDF file", "GeoJSON file", "picture"),
    # Of the polars that come with the program: tools/make_polars.py.
    "ORC certificate {}: {}, {}; collected by {}",
    # Two fields side by side, of which the first is one of these: nothing tells where it ends.
    *(f"There is no {what} {{}}; check the name and the folder." for what in _FILES),
    *(f"The {what} {{}} cannot be read: {{}}." for what in _FILES),
    *(f"The file {{}} {what}." for what in _TROUBLES),
    "{} to {} N, {} to {} E",
    # Why parts of a log are no steady sailing, counted.
    *(
        "{} missing wind or speed",
        "{} beside a gap",
        "{} stopped",
        "{} calm",
        "{} under engine",
        "{} turning",
    ),
    *("{} after a tack or gybe", "{} wind shifting", "{} accelerating", "{} log against receiver"),
    *("No such file or directory", "Permission denied", "Is a directory", "No space left on device"),
)
"""What sentences are filled with, and words of which the rest is a table or a file."""


def templates(root: Path) -> list[str]:
    """Give all templates of a checkout, sorted."""
    found = set(WORDS)
    package = root / "seacruise"
    for path in sorted(package.rglob("*.py")):
        name = path.relative_to(package).as_posix()
        if name.split("/")[0] != _ELSEWHERE and path.name not in _NOT_HEARD:
            found.update(
                _of_module(ast.parse(path.read_text("utf-8")), raises_only=bool(_RAISES_ONLY.fullmatch(name)))
            )
    return sorted(found)


def _of_module(tree: ast.Module, *, raises_only: bool) -> Iterator[str]:
    passed_over = _passed_over(tree)
    roots: list[ast.AST] = [tree]
    if raises_only:
        roots = [node for node in ast.walk(tree) if isinstance(node, ast.Raise)]
    for root in roots:
        for node in ast.walk(root):
            if id(node) not in passed_over and (text := _template(node)) is not None and _is_said(text):
                yield text.strip()


def _is_said(text: str) -> bool:
    plain = text.replace("{}", "")
    return bool(_A_WORD.search(plain)) and " " in text.strip() and _NO_SENTENCE.search(text) is None


def _template(node: ast.AST) -> str | None:
    if isinstance(node, ast.Constant) and isinstance(node.value, str):
        # Braces of a plain string are its own.
        return None if "{" in node.value else node.value
    if isinstance(node, ast.JoinedStr):
        parts = (part.value if isinstance(part, ast.Constant) else "{}" for part in node.values)
        return "".join(str(part) for part in parts)
    return None


def _passed_over(tree: ast.Module) -> set[int]:
    """Give nodes that nobody hears: docstrings, annotations, logs, SQL, parts of f-strings."""
    found: set[int] = set()

    def drop(node: ast.AST | None) -> None:
        if node is not None:
            found.update(id(inner) for inner in ast.walk(node))

    for node in ast.walk(tree):
        match node:
            case ast.Expr(value=ast.Constant()):
                drop(node)
            case ast.JoinedStr(values=parts):
                for part in parts:
                    if isinstance(part, ast.Constant):
                        found.add(id(part))
                    elif isinstance(part, ast.FormattedValue):
                        drop(part.format_spec)
            case ast.AnnAssign(annotation=annotation) | ast.arg(annotation=annotation):
                drop(annotation)
            case ast.FunctionDef(returns=returns):
                drop(returns)
            case ast.Call(func=ast.Attribute(attr=name) | ast.Name(id=name)) if (
                name in _DUMB_CALLS or name in _DUMB_ERRORS
            ):
                drop(node)
    return found
