"""Reader of setup.py, setup.cfg and pyproject.toml files. It does not run the files."""

from __future__ import annotations

import re
import sys
from typing import TYPE_CHECKING, Any

from zbot.package.errors import SetupFileError

if TYPE_CHECKING:
    import ast
    import configparser
    from collections.abc import Iterator
    from pathlib import Path

_MAX_BYTES = 256 * 1024
# Before Python 3.14, the position of an error is only in its message.
_POSITION = re.compile(r" \(at (?:line (?P<line>\d+), column \d+|end of document)\)\Z")
_LONGEST_REASON = 300  #: in characters. Python's reason contains the whole line
_MANY_SPACES = re.compile(r"([^\S\n]{100})[^\S\n]+")
_MAX_LINES = 5000  #: of a setup.cfg
# A word with a dot after it, a hundred times, outside of quotes.
_LONG_KEY = re.compile(r"(?<![\w-])(?:[\w-]+[ \t]*\.[ \t]*){100}")
_QUOTED = re.compile(r"\"(?:\\.|[^\"\\\n])*\"?|'[^'\n]*'?")
_SCRIPTS = "project.scripts must be a table with texts of the form 'package.module:function'"


def declared_scripts(folder: Path) -> dict[str, str]:
    """Return the console scripts of a package as a dictionary: name -> `module:function`.

    Raises:
        SetupFileError: A setup file cannot be read.
    """
    pairs = (text.partition("=") for _, text in script_lines(folder))
    return {name.strip(): _without_extras(target) for name, _, target in pairs if target.strip()}


def script_lines(folder: Path) -> list[tuple[Path, str]]:
    """Return the declarations of console scripts as written, each with the file that contains it.

    Raises:
        SetupFileError: A setup file cannot be read.
    """
    python, config, project = (
        folder / name for name in ("setup.py", "setup.cfg", "pyproject.toml")
    )
    lines = [
        *((python, text) for text in _setup_py_scripts(python)),
        *((config, text) for text in _setup_cfg(config, "options.entry_points", "console_scripts")),
        *((project, text) for text in project_scripts(project, _read(project))),
    ]
    return [(path, text) for path, text in lines if isinstance(text, str) and text.strip()]


def data_files(folder: Path) -> Iterator[tuple[str, str]]:
    """Yield the target folder and the path of each data file in a package's setup.py.

    Raises:
        SetupFileError: The setup.py cannot be read.
    """
    for entry in _items(setup_arguments(folder / "setup.py", "data_files").get("data_files")):
        if isinstance(entry, (tuple, list)) and len(entry) == 2 and isinstance(entry[0], str):
            files = entry[1] if isinstance(entry[1], (tuple, list)) else ()
            yield from ((entry[0], file) for file in files if isinstance(file, str))


def setup_arguments(path: Path, wanted: str = "setup") -> dict[str, Any]:
    """Return the arguments of a setup.py's `setup()` that can be known without running the file.

    Args:
        path: The file, which may be missing.
        wanted: A word. A file that does not contain the word is not parsed.

    Raises:
        SetupFileError: The file is not valid Python.
    """
    source = _read(path)  # bytes, because the first lines may declare an encoding
    if wanted.encode() not in source:
        return {}
    import ast  # noqa: PLC0415 - takes 8 ms

    from zbot.package.literal import LiteralLimitError, Literals  # noqa: PLC0415 - as above
    from zbot.package.python_source import parse_source  # noqa: PLC0415 - as above

    try:
        tree = parse_source(source)
    except SyntaxError as exc:
        raise SetupFileError(path, f"{type(exc).__name__}: {exc.msg}", exc.lineno or 0) from None
    except (ValueError, RecursionError, MemoryError) as exc:
        raise SetupFileError(path, str(exc)) from None
    try:
        literals = Literals(tree, path.parent)
        calls = (node for node in ast.walk(tree) if isinstance(node, ast.Call))
        return next((_keywords(call, literals) for call in calls if _is_setup(call.func)), {})
    except RecursionError:
        raise SetupFileError(path, "its expressions are nested too deeply") from None
    except LiteralLimitError as exc:
        raise SetupFileError(path, str(exc)) from None


def _is_setup(function: ast.expr) -> bool:
    return getattr(function, "id", getattr(function, "attr", "")) == "setup"


def _keywords(call: ast.Call, literals: Any) -> dict[str, Any]:
    found: dict[str, Any] = {}
    for keyword in call.keywords:
        value = literals.value(keyword.value)
        if keyword.arg:
            found[keyword.arg] = value
        elif isinstance(value, dict):  # setup(**arguments)
            found.update(value)
    return found


def _without_extras(target: str) -> str:
    return target.partition("[")[0].strip()


def _text(path: Path) -> str:
    try:
        return _read(path).decode()
    except UnicodeDecodeError as exc:
        raise SetupFileError(path, str(exc)) from exc


def _read(path: Path) -> bytes:
    try:
        with path.open("rb") as file:
            source = file.read(_MAX_BYTES + 1)
    except FileNotFoundError:
        return b""
    except OSError as exc:
        raise SetupFileError(path, exc.strerror or str(exc)) from exc
    if len(source) > _MAX_BYTES:
        raise SetupFileError(path, f"it has more than {_MAX_BYTES} bytes")
    return source


def _setup_py_scripts(path: Path) -> list[Any]:
    groups = setup_arguments(path, "console_scripts").get("entry_points")
    scripts = groups.get("console_scripts") if isinstance(groups, dict) else None
    return scripts.splitlines() if isinstance(scripts, str) else _items(scripts)


def _items(value: Any) -> list[Any]:
    return list(value) if isinstance(value, (list, tuple)) else []


def _setup_cfg(path: Path, section: str, option: str) -> list[str]:
    source = _text(path)
    if option not in source:
        return []
    import configparser  # noqa: PLC0415 - few packages declare scripts there

    try:
        config = parsed_setup_cfg(source)
    except configparser.Error as exc:
        raise SetupFileError(path, exc.message.replace("\n", " ")[:_LONGEST_REASON]) from None
    return config.get(section, option, fallback="").splitlines()


def parsed_setup_cfg(source: str) -> configparser.ConfigParser:
    """Return the sections of a `setup.cfg`. Spaces after the first 100 in a row are left out.

    In a line without `=`, the parser of Python needs a time that grows with the square of these
    spaces: 4 s for 17,000. The time also grows with the square of the number of such lines: 5 s for
    33,000. So the number of lines has a limit.

    Raises:
        configparser.Error: The text is not valid, or has too many lines.
    """
    import configparser  # noqa: PLC0415 - few packages declare scripts there

    if source.count("\n") > _MAX_LINES:
        raise configparser.Error(f"it has more than {_MAX_LINES} lines")
    parser = configparser.ConfigParser(interpolation=None)
    parser.read_string(_MANY_SPACES.sub(r"\1", source))
    return parser


def project_table(path: Path, source: bytes) -> dict[str, Any]:
    """Return the table `project` of a pyproject.toml. It is empty if there is no such table.

    Args:
        path: The file, for errors.
        source: The content of the file.

    Raises:
        SetupFileError: The content is not valid TOML.
    """
    project = _parsed(path, source).get("project", {})
    return project if isinstance(project, dict) else {}


def project_scripts(path: Path, source: bytes) -> list[str]:
    """Return the console scripts of a pyproject.toml, each as `name=module:function`.

    Args:
        path: The file, for errors.
        source: The content of the file.

    Raises:
        SetupFileError: The content is not valid TOML, or the scripts are not a table of texts.
    """
    scripts = project_table(path, source).get("scripts", {})
    if not isinstance(scripts, dict) or not all(
        isinstance(script, str) for script in scripts.values()
    ):
        raise SetupFileError(path, _SCRIPTS)
    return [f"{name}={target}" for name, target in scripts.items()]


def _parsed(path: Path, source: bytes) -> dict[str, Any]:
    if sys.version_info >= (3, 11):
        import tomllib  # noqa: PLC0415 - takes some ms, and few packages have the file
    else:
        import tomli as tomllib  # noqa: PLC0415 - as above

    try:
        text = source.decode()
    except UnicodeDecodeError as exc:
        raise SetupFileError(path, str(exc), source.count(b"\n", 0, exc.start) + 1) from None
    if _LONG_KEY.search(_QUOTED.sub("a", text)):
        # The parser of Python needs 13 s for a key with 30,000 parts.
        raise SetupFileError(path, "a key in it has more than 100 parts")
    try:
        return tomllib.loads(text)
    except tomllib.TOMLDecodeError as exc:
        raise _error(path, text, str(exc)) from None
    except ValueError:  # Python converts at most 4,300 digits
        raise SetupFileError(path, "a number in it has too many digits") from None
    except RecursionError:
        raise SetupFileError(path, "its values are nested too deeply") from None


def _error(path: Path, text: str, message: str) -> SetupFileError:
    position = _POSITION.search(message)
    if position is None:
        return SetupFileError(path, message)
    line = int(position["line"] or len(text.splitlines()))
    return SetupFileError(path, message[: position.start()], line)
