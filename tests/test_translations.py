"""The translations are complete, and compiled from what is in the sources."""

from __future__ import annotations

import ast
import re
from pathlib import Path

import pytest

from tools import translations
from tools.sentences import templates

ROOT = Path(__file__).resolve().parents[1]


def test_everything_is_translated_and_compiled() -> None:
    assert translations.check() == []


def test_plurals_have_all_forms() -> None:
    forms = {"pl": 3, "en": 2}
    for language, number in forms.items():
        for word, texts in translations.read_ts(translations.ts_path(language)):
            assert len(texts) == (number if word.plural else 1), word


def test_templates_of_the_core(tmp_path: Path) -> None:
    package = tmp_path / "seacruise"
    (package / "desktop").mkdir(parents=True)
    (package / "core.py").write_text(
        '"""A docstring is not said."""\n'
        "import logging\n"
        "log = logging.getLogger(__name__)\n"
        "def f(n: 'an annotation here', name):\n"
        '    log.warning("Only the log says %s.", n)\n'
        '    raise InputError(f"{name} has {n:.1f} faults"\n'
        "                     f\"; mend {'it' if n else 'them all'}.\")\n"
    )
    (package / "desktop" / "window.py").write_text('x = "The window says this itself."\n')
    found = set(templates(tmp_path))
    assert "{} has {} faults; mend {}." in found
    assert "them all" in found
    assert not any("log says" in text or "docstring" in text or "annotation" in text for text in found)
    assert not any("window" in text for text in found)


def test_only_literals_can_be_translated(tmp_path: Path) -> None:
    desktop = tmp_path / "seacruise" / "desktop"
    desktop.mkdir(parents=True)
    (desktop / "a.py").write_text('class A:\n    def f(self, x):\n        return self.tr(f"{x} h")\n')
    with pytest.raises(ValueError, match=r"a\.py, line 3: only literals"):
        translations.window_words(tmp_path)


def test_words_are_found_in_their_contexts(tmp_path: Path) -> None:
    desktop = tmp_path / "seacruise" / "desktop"
    desktop.mkdir(parents=True)
    (desktop / "words.py").write_text(
        'def tr(text):\n    """Translate."""\n    return QCoreApplication.translate("pages", text)\n'
        'A = tr("one")\n'
    )
    (desktop / "page.py").write_text(
        "from seacruise.desktop.words import tr as _\n"
        'class Page:\n    def f(self, n):\n        return self.tr("%n port(s)", "", n), _("two " "words")\n'
        'X = QCoreApplication.translate("other", "three", "remark")\n'
    )
    assert translations.window_words(tmp_path) == sorted(
        [
            translations.Word("pages", "one"),
            translations.Word("pages", "two words"),
            translations.Word("Page", "%n port(s)", plural=True),
            translations.Word("other", "three", "remark"),
        ]
    )


@pytest.mark.parametrize(
    ("text", "translation", "fault"),
    [
        ("{n} h", "{m} h", "other placeholders"),
        ("{n:.1f} kn", "{n:.1f} w.", ""),
        ("&Open", "Otwórz", "other mnemonics"),
        ("&Open", "Otwó&rz", ""),
        (" h", "h", "other blanks at an end"),
        ("Open", "", "not translated"),
    ],
)
def test_faults_of_a_translation(text: str, translation: str, fault: str) -> None:
    assert translations.fault_of(translations.Word("X", text), translation) == fault


def test_fields_of_the_core_may_change_places() -> None:
    word = translations.Word("core", "{}: {} request{}")
    assert translations.fault_of(word, "zapytań {1}: {0}") == ""
    assert translations.fault_of(word, "zapytań: {0}") == "other placeholders"
    assert translations.fault_of(word, "{}: zapytań {}{}") == ""


# Names of months and days in numbers' clothes: they would be English in every language.
_ENGLISH_DATES = re.compile(r"%[aAbB]")


def test_the_window_writes_dates_by_the_locale() -> None:
    for path in (ROOT / "seacruise" / "desktop").rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text("utf-8"))):
            if isinstance(node, ast.Constant) and isinstance(node.value, str):
                assert not _ENGLISH_DATES.search(node.value), f"{path.name}, line {node.lineno}"
