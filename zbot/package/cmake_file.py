"""Reader of CMakeLists.txt files. It finds the programs, files and interfaces to install."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterator

_COMMENT = re.compile(r"#\[\[.*?\]\]|#[^\n]*", re.DOTALL)
_COMMAND = re.compile(
    r"\b(?P<name>[A-Za-z_]\w{0,63})\s*\((?P<words>(?:\"[^\"]*\"|[^()\"]|\([^()]*\))*)\)"
)
_WORD = re.compile(r'"([^"]*)"|([^\s"]+)')
_VARIABLE = re.compile(r"\$\{(\w+)\}")
_MAX_EXPANSIONS = 8
#: Keywords of install() that end its list of file names.
_ENDS = {
    "DESTINATION", "RENAME", "PATTERN", "PERMISSIONS", "FILES_MATCHING", "REGEX", "OPTIONAL",
    "USE_SOURCE_PERMISSIONS", "FILE_PERMISSIONS", "DIRECTORY_PERMISSIONS", "COMPONENT",
}  # fmt: skip


@dataclass
class Installation:
    """Files to install. The keys of `programs` and `files` are paths below the install prefix."""

    programs: dict[str, Path] = field(default_factory=dict)
    files: dict[str, Path] = field(default_factory=dict)
    interfaces: dict[str, int] = field(default_factory=dict)  #: file -> line that names it
    compiled: dict[str, int] = field(default_factory=dict)  #: C++ program -> line that adds it
    missing: dict[str, int] = field(default_factory=dict)  #: file that does not exist -> line


def read_cmake(folder: Path) -> Installation:
    """Return what the CMakeLists.txt of a folder installs. Empty if there is no such file.

    The reader reads the commands in order, in all branches of each `if()`. It leaves out values
    that only CMake can compute.
    """
    try:
        text = (folder / "CMakeLists.txt").read_text(encoding="utf-8", errors="replace")
    except OSError:
        return Installation()
    return _Reader(folder, text).installation


class _Reader:
    def __init__(self, folder: Path, text: str) -> None:
        self._folder = folder
        self._variables = {
            "CMAKE_CURRENT_SOURCE_DIR": [str(folder)],
            "CMAKE_SOURCE_DIR": [str(folder)],
            "PROJECT_SOURCE_DIR": [str(folder)],
        }
        self.installation = Installation()
        # Comments become empty lines, so that line numbers do not change.
        blanked = _COMMENT.sub(lambda found: "\n" * found[0].count("\n"), text)
        for command in _COMMAND.finditer(blanked):
            words = list(self._words(command["words"]))
            read = getattr(self, f"_read_{command['name'].lower()}", None)
            if read is not None and words:
                read(words, blanked.count("\n", 0, command.start()) + 1)

    def _words(self, text: str) -> Iterator[str]:
        for quoted, plain in _WORD.findall(text):
            if (only := _VARIABLE.fullmatch(plain)) is not None:
                yield from self._variables.get(only[1], (plain,))
            else:
                yield self._expanded(quoted or plain)

    def _expanded(self, word: str) -> str:
        for _ in range(_MAX_EXPANSIONS):
            replaced = _VARIABLE.sub(self._value, word)
            if replaced == word:
                break
            word = replaced
        return word

    def _value(self, found: re.Match[str]) -> str:
        # An unknown variable stays as `${NAME}`, so that `_read_install` can recognize it.
        return ";".join(self._variables[found[1]]) if found[1] in self._variables else found[0]

    def _read_project(self, words: list[str], _line: int) -> None:
        self._variables["PROJECT_NAME"] = words[:1]

    def _read_set(self, words: list[str], _line: int) -> None:
        end = words.index("CACHE") if "CACHE" in words else len(words)
        self._variables[words[0]] = [part for word in words[1:end] for part in word.split(";")]

    def _read_file(self, words: list[str], _line: int) -> None:
        if words[0] in {"GLOB", "GLOB_RECURSE"} and len(words) > 1:
            patterns = [word for word in words[2:] if word not in {"CONFIGURE_DEPENDS", "RELATIVE"}]
            found = [str(file) for pattern in patterns for file in self._glob(words[0], pattern)]
            self._variables[words[1]] = found

    def _glob(self, kind: str, pattern: str) -> list[Path]:
        relative = pattern.removeprefix(f"{self._folder}/")
        find = self._folder.rglob if kind == "GLOB_RECURSE" else self._folder.glob
        try:
            return sorted(find(relative))
        except (ValueError, NotImplementedError):  # the pattern is not valid in Python
            return []

    def _read_add_executable(self, words: list[str], line: int) -> None:
        self.installation.compiled[words[0]] = line

    def _read_rosidl_generate_interfaces(self, words: list[str], line: int) -> None:
        for word in words[1:]:
            if word in {"DEPENDENCIES", "LIBRARY_NAME", "ADD_LINTER_TESTS", "SKIP_INSTALL"}:
                break
            path = Path(word.rpartition(":")[2])
            inside = path.relative_to(self._folder) if path.is_relative_to(self._folder) else path
            self.installation.interfaces[inside.as_posix()] = line

    def _read_install(self, words: list[str], line: int) -> None:
        kind, options = words[0], words[1:]
        if "DESTINATION" not in options[:-1] or kind not in {"PROGRAMS", "FILES", "DIRECTORY"}:
            return
        target = options[options.index("DESTINATION") + 1].strip("/")
        for name in options[: next(i for i, word in enumerate(options) if word in _ENDS)]:
            if "${" in name or "$<" in name:
                continue
            if not (self._folder / name).exists():
                self.installation.missing[name] = line
            elif kind == "DIRECTORY":
                self._add_folder(name, target)
            else:
                new = options[options.index("RENAME") + 1] if "RENAME" in options[:-1] else ""
                self._add(kind, self._folder / name, f"{target}/{new or Path(name).name}")

    def _add(self, kind: str, path: Path, target: str) -> None:
        if path.is_file():
            group = self.installation.programs if kind == "PROGRAMS" else self.installation.files
            group[target] = path

    def _add_folder(self, name: str, target: str) -> None:
        # As in CMake, `a` becomes the folder target/a. Of `a/`, only the content goes into target.
        source = self._folder / name
        start = target if name.endswith("/") else f"{target}/{source.name}"
        for path in sorted(source.rglob("*")):
            if path.is_file():
                self.installation.files[f"{start}/{path.relative_to(source).as_posix()}"] = path
