"""Errors for a path on the command line of `zbot run` that is not a Python program."""

from __future__ import annotations

from pathlib import Path

from zbot.errors.suggestion import question, similar_names
from zbot.package.workspace import MANIFEST
from zbot_cli.errors import CommandError

_LAUNCH_ENDINGS = (
    ".launch.py",
    "_launch.py",
    ".launch.xml",
    ".launch.yaml",
    ".launch.yml",
    ".launch",
)


def missing_file(word: str) -> CommandError:
    """Return the error for a path without a file."""
    path = Path(word)
    if path.is_dir():
        return folder(path)
    here = [path.name] if Path(path.name).is_file() else []  # `lessons/talker.py` in `lessons`
    near = question(here or map(str, _similar(path)))
    if not near and len(path.parts) == 2 and all(map(str.isidentifier, path.parts)):
        near = f"a package and its program are two words: zbot run {' '.join(path.parts)}"
    return CommandError(f"File '{word}' not found", hint=near)


def folder(path: Path) -> CommandError:
    """Return the error for the path of a folder."""
    programs = sorted(path.glob("*.py"))
    hint = "name a program: zbot run FILE.py, or zbot run PACKAGE PROGRAM"
    if (path / MANIFEST).is_file():
        hint = f"name the package and a program of it: zbot run {path.resolve().name} PROGRAM"
    elif programs:
        hint = f"name a file in it, e.g. zbot run {programs[0]}"
    return CommandError(f"'{path}' is a folder, not a program", hint=hint)


def launch_file(words: str) -> CommandError | None:
    """Return the error for words that name a launch file, or `None` for other words."""
    if not words.endswith(_LAUNCH_ENDINGS):
        return None
    return CommandError(f"'{words}' is a launch file", hint=f"type: zbot launch {words}")


def not_python(word: str) -> CommandError:
    """Return the error for a file that is not a Python program."""
    ending = Path(word).suffix
    hint = "zbot runs Python programs: C++ needs ROS 2" if ending in {".cpp", ".cc", ".c"} else ""
    return CommandError(f"'{word}' is not a Python program", hint=hint)


def _similar(path: Path) -> list[Path]:
    parent = path.parent
    if not parent.is_dir():
        above = parent.parent
        beside = [entry.name for entry in above.iterdir()] if above.is_dir() else []
        found = [above / name / path.name for name in similar_names(parent.name, beside)]
        return [file for file in found if file.is_file()]
    files = [file.name for file in parent.iterdir() if file.suffix == ".py"]
    return [parent / name for name in similar_names(path.name, files)]
