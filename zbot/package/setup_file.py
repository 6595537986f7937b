"""What the setup files of a Python package declare, read without running any of them."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any

from zbot.errors import ZbotError

if TYPE_CHECKING:
    import ast
    from collections.abc import Iterator
    from pathlib import Path

_SECTION = re.compile(r"\s*\[\s*project\s*\.\s*scripts\s*\]\s*(#.*)?\Z")
_ENTRY = re.compile(r"""\s*["']?(?P<name>[\w.-]+)["']?\s*=\s*["'](?P<target>[^"']*)["']""")


class SetupFileError(ZbotError):
    """A package's setup file cannot be read.

    Attributes:
        path: The file.
        reason: What is wrong with it.
        line: Where, counted from 1; 0 if it is the whole file.
    """

    def __init__(self, path: Path, reason: str, line: int = 0) -> None:
        self.path, self.reason, self.line = path, reason, line
        where = f"line {line}: " if line else ""
        super().__init__(f"cannot read {path}: {where}{reason}")


def declared_scripts(folder: Path) -> dict[str, str]:
    """Return the console scripts of a package: name -> `module:function`.

    Raises:
        SetupFileError: A file of it is not what it should be.
    """
    pairs = (text.partition("=") for _, text in script_lines(folder))
    return {name.strip(): _without_extras(target) for name, _, target in pairs if target.strip()}


def script_lines(folder: Path) -> list[tuple[Path, str]]:
    """Return the console scripts of a package as they are written, with the file that has each.

    Raises:
        SetupFileError: A file of it is not what it should be.
    """
    python, config, project = (folder / one for one in ("setup.py", "setup.cfg", "pyproject.toml"))
    lines = [
        *((python, text) for text in _setup_py_scripts(python)),
        *((config, text) for text in _setup_cfg(config, "options.entry_points", "console_scripts")),
        *((project, text) for text in _pyproject(project)),
    ]
    return [(path, text) for path, text in lines if isinstance(text, str) and text.strip()]


def data_files(folder: Path) -> Iterator[tuple[str, str]]:
    """Yield each data file of a package, relative to its folder, with the folder it goes to.

    Raises:
        SetupFileError: A file of it is not what it should be.
    """
    for entry in setup_arguments(folder / "setup.py", "data_files").get("data_files") or ():
        if isinstance(entry, (tuple, list)) and len(entry) == 2 and isinstance(entry[0], str):
            files = entry[1] if isinstance(entry[1], (tuple, list)) else ()
            yield from ((entry[0], file) for file in files if isinstance(file, str))


def setup_arguments(path: Path, wanted: str = "setup") -> dict[str, Any]:
    """Return what a setup.py hands to `setup()`, as far as it can be known without running it.

    Args:
        path: The file; it need not be there.
        wanted: A word without which the file need not be looked at.

    Raises:
        SetupFileError: It is no Python, or no text.
    """
    source = _read(path)  # in bytes: its first lines may say which encoding it has
    if wanted.encode() not in source:
        return {}
    import ast  # noqa: PLC0415 - 8 ms that only a setup.py needs

    from zbot.package.literal import Literals  # noqa: PLC0415 - as above

    try:
        tree = ast.parse(source)
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
        return path.read_bytes()
    except FileNotFoundError:
        return b""
    except OSError as exc:
        raise SetupFileError(path, exc.strerror or str(exc)) from exc


def _setup_py_scripts(path: Path) -> list[Any]:
    groups = setup_arguments(path, "console_scripts").get("entry_points")
    scripts = groups.get("console_scripts") if isinstance(groups, dict) else None
    return scripts.splitlines() if isinstance(scripts, str) else list(scripts or ())


def _setup_cfg(path: Path, section: str, option: str) -> list[str]:
    source = _text(path)
    if option not in source:
        return []
    import configparser  # noqa: PLC0415 - few packages declare scripts there

    parser = configparser.ConfigParser(interpolation=None)
    try:
        parser.read_string(source)
    except configparser.Error as exc:
        raise SetupFileError(path, exc.message.replace("\n", " ")) from None
    return parser.get(section, option, fallback="").splitlines()


def _pyproject(path: Path) -> list[str]:
    # Python has a TOML parser from 3.11 on; a table of texts needs none.
    lines, inside = [], False
    for line in _text(path).splitlines():
        if line.lstrip().startswith("["):
            inside = _SECTION.match(line) is not None
        elif inside and (match := _ENTRY.match(line)):
            lines.append(f"{match['name']}={match['target']}")
    return lines
