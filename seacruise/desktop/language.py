"""The language of the window: which one, Qt's part of it, and the core's sentences at the window's border.

The core speaks plain English; what it says in files and in the terminal stays so. What the window shows of
it goes through `sentence`, which knows the core's sentences as templates (``assets/translations/core.json``,
made by ``tools/translations.py``) and fills the translated ones. What is not known stays as it is.
"""

from __future__ import annotations

import json
import logging
import os
import re
import string
from collections.abc import Mapping
from functools import lru_cache
from itertools import pairwise
from typing import TYPE_CHECKING, Any, Final, NamedTuple

from PySide6.QtCore import QT_TRANSLATE_NOOP, QCoreApplication, QLibraryInfo, QLocale, QTranslator

from seacruise.errors import InputError
from seacruise.resources import resource_path

if TYPE_CHECKING:
    from seacruise.desktop.memory import WindowMemory

log = logging.getLogger(__name__)

ENGLISH: Final = "en"
LANGUAGES: Final = (ENGLISH, "pl")
"""English first: it is what the program says where nothing else is known."""

_LOCALES: Final = {"en": "en_GB", "pl": "pl_PL"}
_KEPT_AS: Final = "language"
_DEEP: Final = 4
_NUMBER: Final = re.compile(r"[+-]?\d+\.\d+")
_DAYS: Final = ("Mon", "Tue", "Wed", "Thu", "Fri", "Sat", "Sun")
_MONTHS: Final = ("Jan", "Feb", "Mar", "Apr", "May", "Jun", "Jul", "Aug", "Sep", "Oct", "Nov", "Dec")
_MOMENT: Final = re.compile(
    rf"(?:(?P<weekday>{'|'.join(_DAYS)}) +)?(?P<day>\d{{1,2}}) (?P<month>{'|'.join(_MONTHS)})"
    r"(?P<rest>(?: \d{4})?(?: \d{2}:\d{2})?(?: UTC)?)"
)
_FIELD: Final = re.compile(r"\{\d*\}")
_BREAK: Final = re.compile(r"(?<=[.!?])\s+(?=\S)|\n+")
_SIGN: Final = re.compile(r"[;:,(] ?[^\d\W]|\band\b")
_LETTERS: Final = re.compile(r"[^\W\d_]")
# A template with so few letters says little; what fills it must be short.
_FEW: Final = 8
_SHORT: Final = 40

_OF_THE_SYSTEM: Final = (
    QT_TRANSLATE_NOOP("system", "No space left on device"),
    QT_TRANSLATE_NOOP("system", "Permission denied"),
    QT_TRANSLATE_NOOP("system", "Read-only file system"),
    QT_TRANSLATE_NOOP("system", "No such file or directory"),
    QT_TRANSLATE_NOOP("system", "Not a directory"),
    QT_TRANSLATE_NOOP("system", "File name too long"),
)
"""What the system says of a file, within sentences of the core; some would be taken for templates of it."""

_translators: list[QTranslator] = []
_current = [ENGLISH]


def _tr(text: str) -> str:
    return QCoreApplication.translate("language", text)


def choices() -> dict[str, str]:
    """Languages to choose from, by their codes; the empty code is the system's language."""
    return {"": _tr("As the system"), "en": "English", "pl": "Polski"}


def chosen(memory: WindowMemory | None) -> str:
    """Code that the sailor chose; empty when the system decides."""
    code = memory.recall(_KEPT_AS).get("code") if memory is not None else None
    return code if code in LANGUAGES else ""


def choose(memory: WindowMemory, code: str) -> None:
    """Keep the sailor's choice; `seacruise.desktop.succession` lets it take effect."""
    memory.keep(_KEPT_AS, {"code": code})


def current() -> str:
    """Code of the language that the window speaks."""
    return _current[0]


def wanted(memory: WindowMemory | None, environ: Mapping[str, str] | None = None) -> str:
    """Decide on a language: ``SEACRUISE_LANGUAGE``, the sailor's choice, the system's, English."""
    asked = (os.environ if environ is None else environ).get("SEACRUISE_LANGUAGE", "").strip()
    for name in (asked, chosen(memory), *QLocale.system().uiLanguages()):
        code = re.split(r"[-_.@]", name)[0].lower()
        if code in LANGUAGES:
            return code
    return ENGLISH


def install(app: QCoreApplication, memory: WindowMemory | None = None) -> str:
    """Speak the wanted language from now on; before the first widget is made. Gives its code."""
    speak(app, code := wanted(memory))
    return code


def speak(app: QCoreApplication, code: str) -> None:
    """Speak a language: words of the window and of Qt's own dialogs, dates and the decimal sign."""
    for translator in _translators:
        app.removeTranslator(translator)
    _translators.clear()
    _known.cache_clear()
    _current[0] = code
    system = QLocale.system()
    own = QLocale(_LOCALES[code])
    QLocale.setDefault(system if system.language() is own.language() else own)
    folders = [QLibraryInfo.path(QLibraryInfo.LibraryPath.TranslationsPath)]
    try:
        folders.append(str(resource_path("assets/translations")))
    except InputError:
        log.warning("The translations are missing.")
    for name, folder in zip(("qtbase", "seacruise"), folders, strict=False):
        translator = QTranslator()
        if translator.load(f"{name}_{code}", folder):
            app.installTranslator(translator)
            _translators.append(translator)


# ------------------------------------------------------------------------------------------------- numbers


class _Formatter(string.Formatter):
    def format_field(self, value: Any, format_spec: str) -> str:
        text = str(format(value, format_spec))
        return text.replace(".", QLocale().decimalPoint()) if isinstance(value, float) else text


_FORMATTER: Final = _Formatter()


def fill(template: str, /, **values: object) -> str:
    """Fill a translated template like ``str.format``; decimal numbers are written as the language does."""
    return _FORMATTER.vformat(template, (), values)


# ----------------------------------------------------------------------------------------------- sentences


def sentence(text: str) -> str:
    """Say a text of the core in the window's language; as it is where that is English or it is not known."""
    return text if current() == ENGLISH or not text else _known().say(text)


@lru_cache(maxsize=1)
def _known() -> Sentences:
    try:
        path = resource_path("assets/translations/core.json")
        templates = json.loads(path.read_text("utf-8"))
    except (InputError, OSError, ValueError):
        log.warning("The list of the core's sentences cannot be read; they stay in English.")
        templates = []
    names = [str(name) for name in _OF_THE_SYSTEM]
    of_the_system = dict(zip(names, map(_system, names), strict=True))
    in_a_sentence = {_lowered(text): _lowered(target) for text, target in of_the_system.items()}
    said = {text: QCoreApplication.translate("core", text) for text in templates}
    return Sentences(of_the_system | in_a_sentence | said)


def _system(text: str) -> str:
    return QCoreApplication.translate("system", text)


def _lowered(text: str) -> str:
    return text[:1].lower() + text[1:]


class _Shape:
    """A template with fields, to be compared with texts."""

    __slots__ = ("_literals", "_pattern", "breaks", "is_open", "letters", "longest", "says_little", "target")

    def __init__(self, source: str, target: str) -> None:
        self._literals = _FIELD.split(source)
        self._pattern: re.Pattern[str] | None = None
        self.breaks = len(_BREAK.findall(source))
        self.is_open = not self._literals[0] or not self._literals[-1]
        self.longest = max(self._literals, key=len)
        self.letters = len(_LETTERS.findall("".join(self._literals)))
        self.says_little = self.letters < _FEW and not self._literals[0]
        self.target = target

    def _made(self) -> re.Pattern[str]:
        """Make the pattern when it is first needed: most never are."""
        pattern = re.escape(self._literals[0])
        for before, after in pairwise(self._literals):
            # The s of a plural, and one of two fields side by side, may be empty.
            may_be_empty = before[-1:].isalpha() or not before or (not after and before[-1:] != " ")
            pattern += ("(.*?)" if may_be_empty else "(.+?)") + re.escape(after)
        return re.compile(pattern, re.DOTALL)

    def values(self, text: str, *, whole: bool) -> tuple[str, ...] | None:
        """Give what fills the fields in a text; ``None`` when it is another sentence.

        Parameters
        ----------
        whole
            What fills the first or the last place of the text may be sentences of its own.
        """
        self._pattern = self._pattern or self._made()
        if (found := self._pattern.fullmatch(text)) is None:
            return None
        for number, value in enumerate(found.groups(), start=1):
            is_outer = whole and (found.start(number) == 0 or found.end(number) == len(text))
            if not is_outer and _BREAK.search(value):
                return None
        return found.groups()


class _Said(NamedTuple):
    """A text in the window's language, and how many letters of it are not known to be so."""

    text: str
    unknown: int


class Sentences:
    """Sentences of the core and their translations.

    Parameters
    ----------
    translations
        By the template; what fills it is ``{}``, in a translation also ``{0}``, ``{1}`` ... in another order.
    """

    def __init__(self, translations: Mapping[str, str]) -> None:
        known = _heads(translations) | dict(translations)
        self._plain = {text: target for text, target in known.items() if "{" not in text}
        shapes = [_Shape(text, target) for text, target in known.items() if "{" in text]
        # What says more is tried first.
        shapes.sort(key=lambda shape: -shape.letters)
        self._open = [(shape.longest, shape) for shape in shapes if shape.is_open]
        self._by_breaks: dict[int, list[tuple[str, _Shape]]] = {}
        for shape in shapes:
            self._by_breaks.setdefault(shape.breaks, []).append((shape.longest, shape))
        self._remember = lru_cache(maxsize=2000)(self._say)

    def say(self, text: str) -> str:
        """Translate a text of one or more sentences, as far as they are known."""
        return self._remember(text, 0).text

    def _say(self, text: str, depth: int) -> _Said:
        if _NUMBER.fullmatch(text):
            return _Said(text.replace(".", QLocale().decimalPoint()), 0)
        if (moment := _MOMENT.fullmatch(text)) is not None:
            return _Said(_own_moment(moment), 0)
        as_it_is = _Said(text, len(_LETTERS.findall(text)))
        if depth > _DEEP or not as_it_is.unknown:
            return as_it_is
        found = self._one(text, depth)
        if gaps := _BREAK.findall(text):
            if found is not None:
                return found
            joined = self._joined(_BREAK.split(text), gaps, depth)
            is_known = joined.unknown < as_it_is.unknown // 3
            whole = None if is_known else self._one(text, depth, whole=True)
            return joined if whole is None or joined.unknown <= whole.unknown else whole
        if found is None and text.endswith(".") and (bare := self._one(text[:-1], depth)) is not None:
            found = _Said(f"{bare.text}.", bare.unknown)
        tries = [found or as_it_is]
        if tries[0].unknown and "; " in text:
            tries.append(self._listed(text, "; ", depth))
        if found is None and depth and ", " in text:
            tries.append(self._listed(text, ", ", depth))
        return min(tries, key=lambda said: said.unknown)

    def _joined(self, pieces: list[str], gaps: list[str], depth: int) -> _Said:
        """Translate several sentences; a template may be more than one of them."""
        said, unknown, at = "", 0, 0
        while at < len(pieces):
            tries = [(self._remember(pieces[at], depth + 1), at + 1)]
            for end in range(at + 2, min(at + 3, len(pieces)) + 1):
                part = pieces[at] + "".join(gaps[i - 1] + pieces[i] for i in range(at + 1, end))
                if (found := self._one(part, depth)) is not None:
                    tries.append((found, end))
            # Of sentences that leave the same part of themselves unknown the shorter ones are the likelier.
            best, end = min(tries, key=lambda tried: tried[0].unknown / max(len(tried[0].text), 1))
            said += best.text + (gaps[end - 1] if end < len(pieces) else "")
            unknown += best.unknown
            at = end
        return _Said(said, unknown)

    def _listed(self, text: str, sign: str, depth: int) -> _Said:
        """Translate each of several things between signs, as far as they are known."""
        parts = [self._remember(part, depth + 1) for part in text.split(sign)]
        return _Said(sign.join(part.text for part in parts), sum(part.unknown for part in parts))

    def _one(self, text: str, depth: int, *, whole: bool = False) -> _Said | None:
        """Translate what is one template; of several, the one that leaves least of the text unknown."""
        bare = text.strip()
        if (target := self._plain.get(bare)) is not None:
            return _Said(text.replace(bare, target), 0)
        best: _Said | None = None
        shapes = self._open if whole else self._by_breaks.get(len(_BREAK.findall(text)), [])
        for shape in [shape for longest, shape in shapes if longest in text]:
            if (values := shape.values(text, whole=whole)) is None:
                continue
            inner = [self._remember(value, depth + 1) for value in values]
            if shape.says_little and any(
                len(value) > _SHORT and said.text == value for value, said in zip(values, inner, strict=True)
            ):
                continue
            unknown = sum(said.unknown for said in inner)
            if best is None or unknown < best.unknown:
                best = _Said(shape.target.format(*(said.text for said in inner)), unknown)
            # Names are never known; what fills a field with a part of the sentence has its signs in it.
            if not unknown or not any(_SIGN.search(value) for value in values):
                break
        return best


def _heads(translations: Mapping[str, str]) -> dict[str, str]:
    """Give what sentences say before their advice: quoted in another one, they are told without it."""
    heads = {}
    for source, target in translations.items():
        head, semicolon, _ = source.partition("; ")
        said, its_semicolon, _ = target.partition("; ")
        if semicolon and its_semicolon and _FIELD.findall(head) == _FIELD.findall(said):
            heads[head] = said
    return heads


def _own_moment(found: re.Match[str]) -> str:
    """Write the core's ``Sun 20 Nov 2016 06:00 UTC`` as the language does; any part of it may be missing."""
    locale, short = QLocale(), QLocale.FormatType.ShortFormat
    weekday = ""
    if found["weekday"]:
        weekday = locale.dayName(_DAYS.index(found["weekday"]) + 1, short) + " "
    return (
        f"{weekday}{found['day']} {locale.monthName(_MONTHS.index(found['month']) + 1, short)}{found['rest']}"
    )
