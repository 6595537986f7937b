"""Reader of CMakeLists.txt files. It finds the programs, files and interfaces to install."""

from __future__ import annotations

import itertools
import os
import re
from collections import ChainMap
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from zbot.package.errors import SetupFileError
from zbot.package.file_search import FileSearch, SearchLimitError

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

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


#: Commands that begin a block, and the commands that end it.
_BLOCKS = {"foreach": "endforeach", "function": "endfunction", "macro": "endmacro"}
_MAX_CALLS = 20_000
_MAX_WORDS = 50_000
_WORD_CHARACTERS = 16  #: characters of a command that count as one word
_MAX_DEPTH = 20


@dataclass
class Installation:
    """Files to install. The keys of `programs` and `files` are paths below the install prefix."""

    programs: dict[str, Path] = field(default_factory=dict)
    files: dict[str, Path] = field(default_factory=dict)
    interfaces: dict[str, int] = field(default_factory=dict)  #: file -> line that names it
    compiled: dict[str, int] = field(default_factory=dict)  #: C++ program -> line that adds it
    missing: dict[str, int] = field(default_factory=dict)  #: file that does not exist -> line
    python_packages: dict[str, Path] = field(default_factory=dict)  #: import name -> folder
    #: Files and folders with tests, as they are written. `${NAME}` is an unknown variable.
    tests: list[str] = field(default_factory=list)


def read_cmake(folder: Path) -> Installation:
    """Return what the CMakeLists.txt of a folder installs, or an empty result without this file.

    The reader reads the commands in order, in all branches of each `if()`. It repeats loops over
    known values, and calls functions and macros of the file. It leaves out values that only CMake
    can compute.

    Raises:
        SetupFileError: The file or its variables are too large, it has too many commands, or its
            patterns search too many files.
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
    """A file is too large to read. The caller adds the file."""


class _Command(NamedTuple):
    name: str
    words: str  #: the text between the parentheses
    line: int


class _Function(NamedTuple):
    parameters: list[str]
    body: range  #: places of its commands


def _commands(text: str) -> Iterator[_Command]:
    line, seen = 1, 0
    for found in _COMMAND.finditer(text):
        line += text.count("\n", seen, found.start())
        seen = found.start()
        yield _Command(found["name"].lower(), found["words"], line)


def _blocks(commands: Sequence[_Command]) -> dict[int, int]:
    """Return the places of the commands that begin and end each block."""
    found, open_blocks = {}, []
    for place, command in enumerate(commands):
        if command.name in _BLOCKS:
            open_blocks.append((place, _BLOCKS[command.name]))
        elif open_blocks and command.name == open_blocks[-1][1]:
            found[open_blocks.pop()[0]] = place
    return found


class _Reader:
    def __init__(self, folder: Path, text: str) -> None:
        self._folder = folder
        self._search = FileSearch(folder)
        self._left = _MAX_EXPANDED
        self._calls = self._depth = self._words_read = 0
        self._functions: ChainMap[str, _Function] = ChainMap()
        self._running: list[str] = []  #: the functions that are being called
        self._variables = ChainMap(
            {
                "CMAKE_CURRENT_SOURCE_DIR": [str(folder)],
                "CMAKE_SOURCE_DIR": [str(folder)],
                "PROJECT_SOURCE_DIR": [str(folder)],
            }
        )
        self.installation = Installation()
        # Comments become empty lines, so that line numbers do not change.
        blanked = _COMMENT.sub(lambda found: "\n" * found[0].count("\n"), text)
        self._commands = list(_commands(blanked))
        self._ends = _blocks(self._commands)
        self._read(range(len(self._commands)))

    def _read(self, places: range) -> None:
        self._depth += 1
        place = places.start
        while place < places.stop:
            self._calls += 1
            if self._calls > _MAX_CALLS or self._depth > _MAX_DEPTH:
                raise _LimitError(f"it has more than {_MAX_CALLS} commands, or too many loops")
            command = self._commands[place]
            words = list(self._words(command.words))
            end = self._ends.get(place)
            if end is not None:
                self._enter(command.name, words, range(place + 1, end))
                place = end
            elif command.name in self._functions and command.name not in self._running:
                self._call(command.name, words)
            elif words:
                self._carry_out(command, words)
            place += 1
        self._depth -= 1

    def _carry_out(self, command: _Command, words: list[str]) -> None:
        read = getattr(self, f"_read_{command.name}", None)
        if read is not None:
            read(words, command.line)

    def _enter(self, kind: str, words: list[str], body: range) -> None:
        if kind == "foreach" and words:
            for value in self._values_of_loop(words[1:]):
                self._variables[words[0]] = [value]
                self._read(body)
            self._variables.pop(words[0], None)
            if any("${" in word for word in words):
                self._read(body)  # the values of the loop are not known
        elif words:
            self._functions[words[0].lower()] = _Function(words[1:], body)

    def _values_of_loop(self, words: list[str]) -> list[str]:
        if "LISTS" in words:
            names = words[words.index("LISTS") + 1 :]
            return [value for name in names for value in self._variables.get(name, [])]
        return [word for word in words if word not in {"IN", "ITEMS"} and "${" not in word]

    def _call(self, name: str, words: list[str]) -> None:
        variables, functions = self._variables, self._functions
        parameters, body = functions[name]
        given = {parameter: [word] for parameter, word in zip(parameters, words, strict=False)}
        # Copies of the variables and functions would take too long if a file has many of them.
        self._variables = variables.new_child({**given, "ARGN": words[len(parameters) :]})
        self._functions = functions.new_child()
        # A function that calls itself would not end, because all branches are read.
        self._running.append(name)
        self._read(body)
        self._running.pop()
        self._variables, self._functions = variables, functions

    def _words(self, text: str) -> Iterator[str]:
        self._count_words(len(text) // _WORD_CHARACTERS)
        for quoted, plain in _WORD.findall(text):
            self._count_words(1)
            if (only := _VARIABLE.fullmatch(plain)) is not None:
                values = self._variables.get(only[1], [plain])
                self._count_words(len(values))
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

    def _count_words(self, number: int) -> None:
        self._words_read += number
        if self._words_read > _MAX_WORDS:
            raise _LimitError(f"it has more than {_MAX_WORDS} words, or too many in its loops")

    def _count(self, characters: int) -> None:
        self._left -= characters
        if self._left < 0:
            raise _LimitError("its variables are too large")

    def _read_project(self, words: list[str], _line: int) -> None:
        self._variables["PROJECT_NAME"] = words[:1]

    def _read_set(self, words: list[str], _line: int) -> None:
        end = words.index("CACHE") if "CACHE" in words else len(words)
        self._variables[words[0]] = [part for word in words[1:end] for part in word.split(";")]

    def _read_list(self, words: list[str], _line: int) -> None:
        if words[0] == "APPEND" and len(words) > 1:
            added = [part for word in words[2:] for part in word.split(";")]
            values = [*self._variables.get(words[1], []), *added]
            self._count(sum(1 + len(value) for value in values))
            self._variables[words[1]] = values

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
        return [str(self._folder / path) for path in found]

    def _read_add_executable(self, words: list[str], line: int) -> None:
        if "${" not in words[0]:
            self.installation.compiled[words[0]] = line

    _read_ament_auto_add_executable = _read_add_executable

    def _read_set_target_properties(self, words: list[str], line: int) -> None:
        if "OUTPUT_NAME" in words[:-1] and words[0] in self.installation.compiled:
            del self.installation.compiled[words[0]]
            self._read_add_executable(words[words.index("OUTPUT_NAME") + 1 :], line)

    def _read_rclcpp_components_register_node(self, words: list[str], line: int) -> None:
        # Such a library also becomes a program that runs only this component.
        if "EXECUTABLE" in words[:-1]:
            self._read_add_executable(words[words.index("EXECUTABLE") + 1 :], line)

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

    def _read_ament_python_install_package(self, words: list[str], _line: int) -> None:
        place = words[words.index("PACKAGE_DIR") + 1] if "PACKAGE_DIR" in words[:-1] else words[0]
        if "${" not in words[0] + place:
            self.installation.python_packages[words[0]] = self._folder / place

    def _read_install(self, words: list[str], line: int) -> None:
        kind, options = words[0], words[1:]
        if "DESTINATION" not in options[:-1] or kind not in {"PROGRAMS", "FILES", "DIRECTORY"}:
            return
        target = options[options.index("DESTINATION") + 1].strip("/")
        new = options[options.index("RENAME") + 1] if "RENAME" in options[:-1] else ""
        has_programs = "USE_SOURCE_PERMISSIONS" in options
        names = itertools.takewhile(lambda word: word not in _ENDS, options)
        for name in dict.fromkeys(names):
            if "${" in name or "$<" in name:
                continue
            if not os.path.exists(self._folder / name):  # noqa: PTH110 - any name is allowed
                self.installation.missing[name] = line
            elif kind == "DIRECTORY":
                self._add_folder(name, target, has_programs=has_programs)
            else:
                self._add(kind, self._folder / name, f"{target}/{new or Path(name).name}")

    def _add(self, kind: str, path: Path, target: str) -> None:
        if os.path.isfile(path):  # noqa: PTH113 - any name is allowed
            group = self.installation.programs if kind == "PROGRAMS" else self.installation.files
            group[target] = path

    def _add_folder(self, name: str, target: str, *, has_programs: bool) -> None:
        # As in CMake, the folder `a` becomes target/a. The content of the folder `a/` goes directly
        # into target.
        source = self._folder / name
        start = target if name.endswith("/") else f"{target}/{source.name}"
        for path in self._search.below(source):
            is_program = has_programs and start.startswith("lib/") and os.access(path, os.X_OK)
            group = self.installation.programs if is_program else self.installation.files
            group[f"{start}/{path.relative_to(source).as_posix()}"] = path
