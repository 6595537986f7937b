"""Check of the setup.py and setup.cfg of a Python package."""

from __future__ import annotations

import configparser
import contextlib
import warnings
from itertools import islice
from typing import TYPE_CHECKING

from zbot.errors.suggestion import nearest, question
from zbot.package.errors import SetupFileError
from zbot.package.python_source import check_source
from zbot.package.setup_file import data_files, parsed_setup_cfg, setup_arguments
from zbot.package.workspace import MANIFEST
from zbot_cli.packages.check.checked_package import Problem, line_of

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path

    from zbot_cli.packages.check.checked_package import CheckedPackage

#: The arguments of `setup()` that the setup.py of a ROS 2 package has.
_ARGUMENTS = (
    "name", "version", "packages", "package_dir", "package_data", "py_modules", "data_files",
    "install_requires", "zip_safe", "author", "author_email", "maintainer", "maintainer_email",
    "url", "keywords", "classifiers", "description", "long_description", "license", "scripts",
    "tests_require", "extras_require", "entry_points", "include_package_data", "python_requires",
)  # fmt: skip
_CFG = (("develop", "script_dir"), ("install", "install_scripts"))
_MOST_NAMES = 20  #: wrong names that are reported. The line of each is searched in the whole file
_INDEX = "share/ament_index/resource_index/packages"


def check_setup_files(checked: CheckedPackage) -> Iterator[Problem]:
    """Yield the problems of the setup files, except wrong entry points and missing files."""
    path = checked.folder / "setup.py"
    if checked.build_type != "ament_python" or not path.is_file():
        return
    try:
        arguments = setup_arguments(path)
        targets = {folder.rstrip("/") for folder, _ in data_files(checked.folder)}
    except SetupFileError:
        return  # the check of the installation reports it
    if arguments.get("name", checked.name) != checked.name:
        return  # all the rest has the wrong name too
    yield from _check_calls(path)
    yield from _check_names(path, arguments)
    yield from _check_data_files(checked, arguments, targets)
    yield from _check_init_files(checked)
    yield from _check_cfg(checked)


def _check_calls(path: Path) -> Iterator[Problem]:
    """Report what Python warns of, e.g. a missing comma between two tuples."""
    with warnings.catch_warnings(record=True) as found:
        warnings.simplefilter("always")
        with contextlib.suppress(SyntaxError, ValueError, RecursionError, MemoryError):
            source = path.read_bytes()
            check_source(source)
            compile(source, str(path), "exec")
    for warning in found:
        yield Problem(path, warning.lineno, str(warning.message))


def _check_names(path: Path, arguments: dict[str, object]) -> Iterator[Problem]:
    guesses = ((name, nearest(name, _ARGUMENTS)) for name in arguments if name not in _ARGUMENTS)
    wrong = ((name, guess) for name, guess in guesses if guess)
    for name, guess in islice(wrong, _MOST_NAMES):
        text = f"setup() has no argument '{name}'{question([guess], '; ')}"
        yield Problem(path, line_of(path, name), text)
    groups = arguments.get("entry_points")
    words = (
        (group for group in groups if isinstance(group, str)) if isinstance(groups, dict) else ()
    )
    typos = (group for group in words if nearest(group, ["console_scripts"]))
    for group in islice(typos, _MOST_NAMES):
        text = f"entry_points has no group '{group}'{question(['console_scripts'], '; ')}"
        yield Problem(path, line_of(path, group), text)


def _check_data_files(
    checked: CheckedPackage, arguments: dict[str, object], targets: set[str]
) -> Iterator[Problem]:
    listed = arguments.get("data_files", [])
    if not isinstance(listed, list) or not all(isinstance(pair, tuple) for pair in listed):
        return  # only a run of the file would show what it installs
    wanted = {_INDEX: f"resource/{checked.name}", f"share/{checked.name}": MANIFEST}
    for target, file in wanted.items():
        if target not in targets:
            entry = f"('{target}', ['{file}'])"
            text = f"data_files lacks {entry}: ROS 2 would not find the package"
            path = checked.folder / "setup.py"
            yield Problem(path, line_of(path, "data_files"), text, is_error=False)


def _check_init_files(checked: CheckedPackage) -> Iterator[Problem]:
    top = checked.folder / checked.name
    folders = {path.parent for path in checked.modules if path.is_relative_to(top)}
    for folder in sorted(folders):
        if (folder / "__init__.py").is_file():
            continue
        near = [path for path in folder.glob("*init*.py") if nearest(path.name, ["__init__.py"])]
        advice = f"rename {near[0].name} to __init__.py" if near else "add an empty __init__.py"
        text = f"{advice}: without it, ROS 2 would not install the modules of this folder"
        yield Problem(near[0] if near else folder, 0, text, is_error=False)


def _check_cfg(checked: CheckedPackage) -> Iterator[Problem]:
    path = checked.folder / "setup.cfg"
    place = f"$base/lib/{checked.name}"
    if not path.is_file():
        lines = " and ".join(f"[{section}] {option}={place}" for section, option in _CFG)
        text = f"there is no setup.cfg: `ros2 run` would not find the programs; write {lines}"
        yield Problem(checked.folder / "setup.py", 0, text, is_error=False)
        return
    try:
        parser = parsed_setup_cfg(path.read_text(encoding="utf-8"))
    except (configparser.Error, UnicodeDecodeError) as error:
        yield Problem(path, getattr(error, "lineno", 0) or 0, " ".join(str(error).split()))
        return
    for section, option in _CFG:
        yield from _check_option(path, parser, section, option, place)


def _check_option(
    path: Path, parser: configparser.ConfigParser, section: str, option: str, place: str
) -> Iterator[Problem]:
    dashes, right = option.replace("_", "-"), f"{option}={place}"
    if parser.has_option(section, dashes):
        text = f"write {option}, not {dashes}: new setuptools refuse the dash"
        yield Problem(path, line_of(path, dashes), text, is_error=False)
        return
    found = parser.get(section, option, fallback="")
    if found != place:
        text = f"write {right}" if found else f"add {right} below [{section}]"
        text += ": `ros2 run` would not find the programs"
        yield Problem(path, line_of(path, option), text, is_error=False)
