"""Reader of CMakeLists.txt files. It finds the programs, files and interfaces to install."""

from __future__ import annotations

import os
import re
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING

from zbot.package.errors import SetupFileError
from zbot.package.file_search import FileSearch, SearchLimitError

if TYPE_CHECKING:
    from collections.abc import Iterator

_COMMENT = re.compile(r"#\[\[.*?(?:\]\]|\Z)|#[^\n]*", re.DOTALL)
_COMMAND = re.compile(
    r"\b(?P<name>[A-Za-z_]\w{0,63})\s*\((?P<words>(?:\"[^\"]*\"|[^()\"]|\([^()]*\))*)\)"
)
_WORD = re.compile(r'"([^"]*)"|([^\s"]+)')
_VARIABLE = re.compile(r"\$\{(\w+)\}")
_MAX_EXPANSIONS = 8
_KEPT = "\0{"  #: stands for a `${` that is not expanded again
_MAX_BYTES = 256 * 1024
_MAX_EXPANDED = 5_000_000  #: characters of all values of variables that a file uses
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
    #: Files and folders with tests, as they are written. `${NAME}` is an unknown variable.
    tests: list[str] = field(default_factory=list)


def read_cmake(folder: Path) -> Installation:
    """Return what the CMakeLists.txt of a folder installs, or an empty result without this file.

    The reader reads the commands in order, in all branches of each `if()`. It leaves out values
    that only CMake can compute.

    Raises:
        SetupFileError: The file or its variables are too large, or its patterns search too many
            files.
    """
    path = folder / "CMakeLists.txt"
    try:
        with path.open("rb") as file:
            source = file.read(_MAX_BYTES + 1)
    except OSError:
        return Installation()
    if len(source) > _MAX_BYTES:
        raise SetupFileError(path, f"it has more than {_MAX_BYTES} bytes")
    try:
        return _Reader(folder, source.decode(errors="replace").replace("\0", "\ufffd")).installation
    except (_LimitError, SearchLimitError) as error:
        raise SetupFileError(path, str(error)) from None


class _LimitError(Exception):
    """The variables of a file are too large. The caller adds the file."""

    def __init__(self) -> None:
        super().__init__("its variables are too large")


class _Reader:
    def __init__(self, folder: Path, text: str) -> None:
        self._folder = folder
        self._search = FileSearch(folder)
        self._left = _MAX_EXPANDED
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
                values = self._variables.get(only[1], [plain])
                self._count(sum(1 + len(value) for value in values))
                yield from values
            else:
                yield self._expanded(quoted or plain)

    def _expanded(self, word: str) -> str:
        for _ in range(_MAX_EXPANSIONS):
            replaced = _VARIABLE.sub(self._value, word)
            if replaced == word:
                break
            word = replaced
        return word.replace(_KEPT, "${")

    def _value(self, found: re.Match[str]) -> str:
        # An unknown variable stays as `${NAME}`, so that `_read_install` recognizes this text.
        if found[1] not in self._variables:
            return found[0].replace("${", _KEPT)
        value = ";".join(self._variables[found[1]])
        self._count(1 + len(value))
        # A value was expanded when it was set. `${` in it is an unknown variable.
        return value.replace("${", _KEPT)

    def _count(self, characters: int) -> None:
        self._left -= characters
        if self._left < 0:
            raise _LimitError

    def _read_project(self, words: list[str], _line: int) -> None:
        self._variables["PROJECT_NAME"] = words[:1]

    def _read_set(self, words: list[str], _line: int) -> None:
        end = words.index("CACHE") if "CACHE" in words else len(words)
        self._variables[words[0]] = [part for word in words[1:end] for part in word.split(";")]

    def _read_file(self, words: list[str], _line: int) -> None:
        if words[0] in {"GLOB", "GLOB_RECURSE"} and len(words) > 1:
            patterns = [word for word in words[2:] if word not in {"CONFIGURE_DEPENDS", "RELATIVE"}]
            found = [file for pattern in patterns for file in self._glob(words[0], pattern)]
            self._variables[words[1]] = found

    def _glob(self, kind: str, pattern: str) -> list[str]:
        relative = pattern.removeprefix(f"{self._folder}/")
        if Path(relative).is_absolute():
            return []  # files outside the package's folder do not belong to the package
        recursive = kind == "GLOB_RECURSE"
        if recursive:  # CMake searches below each folder of the pattern
            place, slash, name = relative.rpartition("/")
            relative = f"{place}{slash}**/{name}"
        found = self._search.matching(relative, recursive=recursive)
        return [str(self._folder / one) for one in found]

    def _read_add_executable(self, words: list[str], line: int) -> None:
        self.installation.compiled[words[0]] = line

    def _read_rosidl_generate_interfaces(self, words: list[str], line: int) -> None:
        for word in words[1:]:
            if word in {"DEPENDENCIES", "LIBRARY_NAME", "ADD_LINTER_TESTS", "SKIP_INSTALL"}:
                break
            path = Path(word.rpartition(":")[2])
            inside = path.relative_to(self._folder) if path.is_relative_to(self._folder) else path
            self.installation.interfaces[inside.as_posix()] = line

    def _read_add_launch_test(self, words: list[str], _line: int) -> None:
        self.installation.tests.append(words[0])

    def _read_ament_add_pytest_test(self, words: list[str], _line: int) -> None:
        self.installation.tests += words[1:2]  # the first word is the name of the test

    _read_add_ros_test = _read_add_ros_isolated_launch_test = _read_add_launch_test
    _read_ament_add_ros_isolated_pytest_test = _read_ament_add_pytest_test

    def _read_install(self, words: list[str], line: int) -> None:
        kind, options = words[0], words[1:]
        if "DESTINATION" not in options[:-1] or kind not in {"PROGRAMS", "FILES", "DIRECTORY"}:
            return
        target = options[options.index("DESTINATION") + 1].strip("/")
        for name in options[: next(i for i, word in enumerate(options) if word in _ENDS)]:
            if "${" in name or "$<" in name:
                continue
            if not os.path.exists(self._folder / name):  # noqa: PTH110 - any name is allowed
                self.installation.missing[name] = line
            elif kind == "DIRECTORY":
                self._add_folder(name, target)
            else:
                new = options[options.index("RENAME") + 1] if "RENAME" in options[:-1] else ""
                self._add(kind, self._folder / name, f"{target}/{new or Path(name).name}")

    def _add(self, kind: str, path: Path, target: str) -> None:
        if os.path.isfile(path):  # noqa: PTH113 - any name is allowed
            group = self.installation.programs if kind == "PROGRAMS" else self.installation.files
            group[target] = path

    def _add_folder(self, name: str, target: str) -> None:
        # As in CMake, the folder `a` becomes target/a. The content of the folder `a/` goes directly
        # into target.
        source = self._folder / name
        start = target if name.endswith("/") else f"{target}/{source.name}"
        for path in self._search.below(source):
            self.installation.files[f"{start}/{path.relative_to(source).as_posix()}"] = path
