"""The words of the window in other languages: ``python tools/translations.py update|release|check``.

``update`` collects the window's words and the core's sentences and merges them into the .ts files by
lupdate; ``release`` compiles these by lrelease; ``check`` tells what is missing. See docs/architecture.md,
"Languages".
"""

from __future__ import annotations

import ast
import json
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ET
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Final

ROOT: Final = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from tools.sentences import templates  # noqa: E402 - found beside this file, whoever starts it

FOLDER: Final = ROOT / "assets" / "translations"
LANGUAGES: Final = ("pl", "en")
"""English is here for its plurals only."""

CORE: Final = "core"
_FIELD: Final = re.compile(r"%n|\{(\w*)(?:[:!][^{}]*)?\}")
_ENTITY: Final = re.compile(r"&(?=\w)(?!(?:amp|lt|gt|nbsp);)")


@dataclass(frozen=True, slots=True, order=True)
class Word:
    """What is to be translated, in its context."""

    context: str
    text: str
    remark: str = ""
    plural: bool = False


# ------------------------------------------------------------------------------------------- collecting


def window_words(root: Path = ROOT) -> list[Word]:
    """Collect the window's words.

    Raises
    ------
    ValueError
        Something other than a literal is translated somewhere; it could not be found.
    """
    found: set[Word] = set()
    for path in sorted((root / "seacruise" / "desktop").rglob("*.py")):
        try:
            found.update(_Collector(path, root).words())
        except ValueError as error:
            raise ValueError(f"{path.relative_to(root)}, {error}") from None
    return sorted(found)


class _Collector:
    """Finds ``self.tr``, ``QCoreApplication.translate`` and the modules' own short names for it."""

    def __init__(self, path: Path, root: Path) -> None:
        self._root = root
        self._tree = ast.parse(path.read_text("utf-8"))
        self._helpers = self._helpers_of(self._tree)

    def words(self) -> Iterator[Word]:
        """Give all words of the module."""
        yield from self._walk(self._tree, "")

    def _walk(self, node: ast.AST, owner: str) -> Iterator[Word]:
        for child in ast.iter_child_nodes(node):
            if isinstance(child, ast.Call) and (word := self._word(child, owner)) is not None:
                yield word
            is_helper = isinstance(child, ast.FunctionDef) and _context_of_helper(child) is not None
            if not is_helper:
                yield from self._walk(child, child.name if isinstance(child, ast.ClassDef) else owner)

    def _word(self, call: ast.Call, owner: str) -> Word | None:
        match call.func:
            case ast.Attribute(value=ast.Name(id="self"), attr="tr"):
                return self._made(call, owner, call.args)
            case ast.Attribute(value=ast.Name(id="QCoreApplication"), attr="translate"):
                return self._made(call, self._literal(call, call.args[0]), call.args[1:])
            case ast.Name(id="QT_TRANSLATE_NOOP"):
                return self._made(call, self._literal(call, call.args[0]), call.args[1:])
            case ast.Name(id=name) if name in self._helpers:
                return self._made(call, self._helpers[name], call.args)
        return None

    def _made(self, call: ast.Call, context: str, args: list[ast.expr]) -> Word | None:
        if context == CORE:
            # What the core says is known from its own modules.
            return None
        remark = self._literal(call, args[1]) if len(args) > 1 else ""
        return Word(context, self._literal(call, args[0]), remark, plural=len(args) > 2)

    @staticmethod
    def _literal(call: ast.Call, node: ast.expr) -> str:
        if isinstance(node, ast.Constant) and isinstance(node.value, str):
            return node.value
        raise ValueError(f"line {call.lineno}: only literals can be translated")

    def _helpers_of(self, tree: ast.Module) -> dict[str, str]:
        found = {}
        for node in tree.body:
            if isinstance(node, ast.FunctionDef) and (context := _context_of_helper(node)) is not None:
                found[node.name] = context
            elif isinstance(node, ast.ImportFrom) and (node.module or "").startswith("seacruise.desktop."):
                there = self._root / ((node.module or "").replace(".", "/") + ".py")
                names = {alias.name: alias.asname or alias.name for alias in node.names}
                if there.exists() and names.keys() & {"tr", "_tr"}:
                    others = self._helpers_of(ast.parse(there.read_text("utf-8")))
                    found |= {names[name]: others[name] for name in names if name in others}
        return found


def _context_of_helper(function: ast.FunctionDef) -> str | None:
    """Context of a function that does nothing but translate its argument."""
    match function.body[-1], function.args.args:
        case (
            ast.Return(
                value=ast.Call(
                    func=ast.Attribute(attr="translate"),
                    args=[ast.Constant(value=str(context)), ast.Name(id=name), *_],
                )
            ),
            [ast.arg(arg=first), *_],
        ) if name == first:
            return context
    return None


# --------------------------------------------------------------------------------------------- the files


def update() -> None:
    """Merge what is to be translated into the .ts files, and write the list of the core's templates."""
    FOLDER.mkdir(parents=True, exist_ok=True)
    core = templates(ROOT)
    _list_path().write_text(json.dumps(core, ensure_ascii=False, indent=0) + "\n", encoding="utf-8")
    words = [*window_words(), *(Word(CORE, text) for text in core)]
    with tempfile.TemporaryDirectory() as folder:
        source = Path(folder) / "words.py"
        source.write_text("\n".join(map(_call, words)) + "\n", encoding="utf-8")
        for language in LANGUAGES:
            options = ["-locations", "none", "-no-obsolete", "-sort-messages", "-source-language", "en"]
            options += ["-target-language", language] + ["-pluralonly"] * (language == "en")
            _run("lupdate", str(source), "-ts", str(ts_path(language)), *options)


def _call(word: Word) -> str:
    args = [word.context, word.text] + [word.remark] * bool(word.remark or word.plural)
    number = ", 1" if word.plural else ""
    return f"QCoreApplication.translate({', '.join(map(_quoted, args))}{number})"


def _quoted(text: str) -> str:
    # lupdate reads a literal byte by byte: escapes of Python that Qt does not know must not be in it.
    return (
        '"' + text.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n").replace("\t", "\\t") + '"'
    )


def release(folder: Path = FOLDER) -> None:
    """Compile the .ts files."""
    for language in LANGUAGES:
        _run("lrelease", str(ts_path(language)), "-qm", str(folder / f"seacruise_{language}.qm"))


def ts_path(language: str) -> Path:
    """Path of a language's texts."""
    return FOLDER / f"seacruise_{language}.ts"


def _list_path() -> Path:
    return FOLDER / "core.json"


def _run(tool: str, *arguments: str) -> None:
    program = Path(sys.executable).with_name(f"pyside6-{tool}")
    done = subprocess.run([str(program), *arguments], capture_output=True, text=True, check=False)
    if done.returncode:
        raise SystemExit(f"{tool} failed: {done.stdout}{done.stderr}")


# ---------------------------------------------------------------------------------------------- checking


def check() -> list[str]:
    """Tell what is wrong with the translations, one line each; nothing when all is well."""
    words = set(window_words()) | {Word(CORE, text) for text in templates(ROOT)}
    listed = json.loads(_list_path().read_text("utf-8"))
    faults = [] if listed == templates(ROOT) else ["core.json is not up to date"]
    for language in LANGUAGES:
        wanted = {word for word in words if word.plural or language != "en"}
        faults += [f"{language}: {fault}" for fault in _faults(language, wanted)]
    with tempfile.TemporaryDirectory() as folder:
        release(Path(folder))
        for language in LANGUAGES:
            made = (Path(folder) / f"seacruise_{language}.qm").read_bytes()
            if not _same_bytes(FOLDER / f"seacruise_{language}.qm", made):
                faults.append(f"{language}: the .qm is not what lrelease makes of the .ts")
    return faults


def _same_bytes(path: Path, data: bytes) -> bool:
    return path.exists() and path.read_bytes() == data


def _faults(language: str, wanted: set[Word]) -> Iterator[str]:
    found = dict(read_ts(ts_path(language)))
    for word in sorted(wanted - found.keys()):
        yield f"not in the .ts: [{word.context}] {word.text!r}"
    for word in sorted(found.keys() - wanted):
        yield f"no longer said: [{word.context}] {word.text!r}"
    for word in sorted(wanted & found.keys()):
        for translation in found[word]:
            if fault := fault_of(word, translation):
                yield f"{fault}: [{word.context}] {word.text!r} -> {translation!r}"


def fault_of(word: Word, translation: str) -> str:
    """Tell in a word or two what is wrong with a translation; empty when nothing is."""
    if not translation:
        return "not translated"
    if not _fits(word, translation):
        return "other placeholders"
    if word.context != CORE and len(_ENTITY.findall(word.text)) != len(_ENTITY.findall(translation)):
        return "other mnemonics"
    if (
        word.text[:1].isspace() != translation[:1].isspace()
        or word.text[-1:].isspace() != translation[-1:].isspace()
    ):
        return "other blanks at an end"
    return ""


def _fits(word: Word, translation: str) -> bool:
    """Whether a translation has the same placeholders; in the core, the ``s`` of a plural may be left out."""
    wanted, given = _fields(word.text), _fields(translation)
    if word.context == CORE and any(given):
        needed = {str(n) for n, match in enumerate(_FIELD.finditer(word.text)) if not _is_ending(match)}
        return needed <= set(given) <= {str(n) for n in range(len(wanted))}
    return sorted(wanted) == sorted(given)


def _is_ending(field: re.Match[str]) -> bool:
    return field.string[field.start() - 1 : field.start()].isalpha()


def _fields(text: str) -> list[str]:
    return [match[1] if match[1] is not None else "%n" for match in _FIELD.finditer(text)]


def read_ts(path: Path) -> Iterator[tuple[Word, list[str]]]:
    """Read a .ts file: each word with its translations, which are several for a plural."""
    for context in ET.parse(path).getroot().iter("context"):  # noqa: S314 - our own file
        name = context.findtext("name") or ""
        for message in context.iter("message"):
            plural = message.get("numerus") == "yes"
            word = Word(name, message.findtext("source") or "", message.findtext("comment") or "", plural)
            target = message.find("translation")
            assert target is not None
            texts = (
                [form.text or "" for form in target.iter("numerusform")] if plural else [target.text or ""]
            )
            yield word, texts if target.get("type") is None else [""]


def main(arguments: list[str]) -> int:
    """Do what is asked."""
    match arguments:
        case ["update"]:
            update()
        case ["release"]:
            release()
        case ["check"]:
            faults = check()
            print("\n".join(faults) or "All is translated.")
            return 1 if faults else 0
        case _:
            print(__doc__)
            return 2
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
