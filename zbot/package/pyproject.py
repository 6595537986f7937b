"""Reader of pyproject.toml files."""

from __future__ import annotations

import re
import sys
from typing import TYPE_CHECKING, Any

from zbot.package.errors import SetupFileError

if TYPE_CHECKING:
    from pathlib import Path

# Before Python 3.14, the position of an error is only in its message.
_POSITION = re.compile(r" \(at (?:line (?P<line>\d+), column \d+|end of document)\)\Z")
_SCRIPTS = "project.scripts must be a table with texts of the form 'package.module:function'"


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
    if not isinstance(scripts, dict) or not all(isinstance(one, str) for one in scripts.values()):
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
