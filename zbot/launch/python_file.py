"""Loader of launch files in Python."""

from __future__ import annotations

import importlib
import inspect
import io
import os
import re
import traceback
import xml.parsers.expat  # noqa: F401 - the package xacro uses it without importing it
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, Any

from zbot.errors import ZbotError
from zbot.errors.installation import pip_install
from zbot.errors.suggestion import correction, did_you_mean, question, similar_names
from zbot.launch.argument_names import other_words
from zbot.launch.description import LaunchDescription
from zbot.launch.environment import how_to_set
from zbot.launch.errors import LaunchFileError, describe
from zbot.launch.not_runnable import missing_file
from zbot.package import python_finder
from zbot.package.ros_variables import AMENT_PREFIX_PATH
from zbot.text.typographic import advise_of_syntax

if TYPE_CHECKING:
    from collections.abc import Iterable

#: Modules that launch files import, and the extra of zbot that installs each module.
_EXTRAS = {"numpy": "numpy", "xacro": "robot"}
FUNCTION = "generate_launch_description"
_OS_FILES = {os.__file__, "<frozen os>"}
#: Modules from which launch files import names, in the order of the search.
_MODULES = (
    "launch",
    "launch.actions",
    "launch_ros.actions",
    "launch.substitutions",
    "launch_ros.substitutions",
    "launch.conditions",
    "launch.launch_description_sources",
    "launch_ros.descriptions",
    "launch_ros.parameter_descriptions",
    "launch.event_handlers",
    "launch_ros.event_handlers",
    "launch.events",
    "launch_xml.launch_description_sources",
    "launch_yaml.launch_description_sources",
    "ament_index_python.packages",
)
_NO_NAME = re.compile(r"cannot import name '(\w+)' from '([\w.]+)'")
_WRONG_CLASS = re.compile(r"cannot import '([A-Z]\w*)' from '([\w.]+)'")
_UNDEFINED = re.compile(r"name '(\w+)' is not defined")
_MISSING_ARGUMENT = re.compile(r"__init__\(\) missing \d+ required keyword-only argument: '(\w+)'")
#: What is written in place of code that raises an error with such a text.
_ADVICE = (
    (
        re.compile(r"LaunchDescription\.__init__\(\) takes from 1 to 2 positional arguments"),
        "put the actions into a list: LaunchDescription([...])",
    ),
    (
        re.compile(r"Node\.__init__\(\) takes 1 positional argument but"),
        "name the arguments, e.g. Node(package='turtlesim', executable='turtlesim_node')",
    ),
    (
        re.compile(r"Node\.__init__\(\) got an unexpected keyword argument '(package|exec\w*)'"),
        "write: from launch_ros.actions import Node",
    ),
    (re.compile(rf"{FUNCTION}\(\) missing \d+ required positional"), f"write: def {FUNCTION}():"),
)
_QUOTED = re.compile(r"'(\w+)'")
#: Arguments of nodes and components until ROS 2 Foxy, and their names today.
_OLD_ARGUMENTS = {
    "node_executable": "executable",
    "node_name": "name",
    "node_namespace": "namespace",
    "node_plugin": "plugin",
}
# A substitution in place of its value: `LaunchConfiguration('name') + '_1'`.
_SUBSTITUTION = re.compile(
    r"(?:for \+: '|concatenate str \(not \"|, not '?)(\w*(?:LaunchConfiguration|Substitution)|"
    r"FindPackageShare|Command|EnvironmentVariable|ThisLaunchFileDir)\b"
)
_READ_VARIABLE = re.compile(r"\b(?:getenv|environ\.get)\(\s*(['\"])(\w+)\1\s*\)")


def load(path: Path) -> LaunchDescription:
    """Return the launch description of a launch file.

    Raises:
        LaunchFileError: The file cannot be read, raises an error, or returns no description.
    """
    returned: Any = None
    try:
        module = load_module(path)
        function = getattr(module, FUNCTION, None)
        if callable(function):
            returned = function()
    except SyntaxError as error:
        advise_of_syntax(error)
        place = error.filename or str(path)
        raise LaunchFileError(place, error.lineno or 0, f"SyntaxError: {error.msg}") from error
    except (Exception, SystemExit) as error:
        raise located(path, error) from error
    if function is None:
        reason = f"the file has no function {FUNCTION}()"
        raise LaunchFileError(str(path), 0, reason, missing_function(module))
    if not isinstance(returned, LaunchDescription):
        line = getattr(getattr(function, "__code__", None), "co_firstlineno", 0)
        raise LaunchFileError(str(path), line, _wrong_result(returned))
    return returned


def load_module(path: str | Path) -> ModuleType:
    """Load a launch file as a module, without adding it to `sys.modules`.

    Raises:
        OSError: The file cannot be read.
        SymlinkInstallError: The file uses AMENT_PREFIX_PATH, and the prefixes cannot be written.
        Exception: The error that the file raises.
    """
    module = ModuleType("launch_file")
    module.__file__ = str(path)
    python_finder.install(searches_always=True)
    with io.open_code(str(path)) as file:
        text = file.read()
    if AMENT_PREFIX_PATH.encode() in text:
        from zbot.package.workspace_prefixes import set_ament_prefix_path  # noqa: PLC0415 - seldom used

        set_ament_prefix_path(Path(path))
    code = compile(text, str(path), "exec")
    exec(code, module.__dict__)  # noqa: S102 - running the user's file is the purpose
    return module


def _wrong_result(returned: object) -> str:
    if returned is None:
        return f"{FUNCTION}() returns nothing: end it with `return LaunchDescription([...])`"
    what = "the class itself" if returned is LaunchDescription else f"a {type(returned).__name__}"
    return f"{FUNCTION}() returns {what}: write `return LaunchDescription([...])`"


def located(path: Path, error: Exception | SystemExit, line: int = 0) -> LaunchFileError:
    """Return an error that shows the line of a launch file that raised another error.

    Args:
        path: The launch file.
        error: The other error.
        line: The line that is shown if no line of the file was running.
    """
    if isinstance(error, LaunchFileError):
        return error
    lines = [
        frame.lineno
        for frame in traceback.extract_tb(error.__traceback__)
        if frame.filename == str(path)
    ]
    line = (lines[-1] if lines else line) or line
    absent = missing_file(error)
    if absent is not None:
        return LaunchFileError(str(path), line, str(absent))
    reason = str(error) if isinstance(error, ZbotError) else describe(error)
    if isinstance(error, SystemExit) and not isinstance(error.code, str):
        cause = f" after {describe(error.__context__)}" if error.__context__ else ""
        code = "" if error.code is None else error.code
        reason = f"the file ended the launch with exit({code}){cause}"
    hint = getattr(error, "hint", "") or ""
    if isinstance(error, TypeError) and (old := _old_arguments(path, str(error))):
        reason = f"{_listed(old)} {'are names' if old[1:] else 'is a name'} of ROS 2 Foxy"
        hint = f"write {_listed(_OLD_ARGUMENTS[name] for name in old)}"
    elif not isinstance(error, ZbotError):
        hint = advice(error)
    elif isinstance(error, ImportError):
        reason, hint = corrected_import(reason)
    if isinstance(error, ModuleNotFoundError) and error.name in _EXTRAS:
        hint = pip_install(f"zbot[{_EXTRAS[error.name]}]")
    elif isinstance(error, ModuleNotFoundError) and not (hint or isinstance(error, ZbotError)):
        hint = "`zbot pkg deps` shows what is missing, and where it is"
    return LaunchFileError(str(path), line, reason, hint)


def _old_arguments(path: Path, text: str) -> list[str]:
    """Return the arguments of ROS 2 Foxy in a launch file, if an error is about one of them."""
    named = set(_QUOTED.findall(text))
    if not named & {*_OLD_ARGUMENTS, *_OLD_ARGUMENTS.values()}:
        return []
    import ast  # noqa: PLC0415 - takes 8 ms

    try:
        nodes = list(ast.walk(ast.parse(path.read_bytes())))
    except (OSError, ValueError, SyntaxError, RecursionError):
        return []  # e.g. a launch file in XML
    given = {node.arg for node in nodes if isinstance(node, ast.keyword)}
    return [name for name in _OLD_ARGUMENTS if name in given]


def _listed(names: Iterable[str]) -> str:
    *first, last = names
    return f"{', '.join(first)} and {last}" if first else last


def advice(error: Exception | SystemExit) -> str:
    """Return what to write in place of the code that raised an error, or an empty string."""
    text = str(error)
    if variable := _unset_variable(error):
        return how_to_set(variable)
    if isinstance(error, TypeError) and (match := _SUBSTITUTION.search(text)):
        return _without_value(match[1], text)
    if isinstance(error, ModuleNotFoundError):
        return correction(error.name or "", [*_MODULES, "launch_ros", "ament_index_python"])
    if match := _NO_NAME.search(text) or _UNDEFINED.search(text):
        name, module = match[1], match[2] if match.re is _NO_NAME else ""
        return _import_of(name) or _similar_of(name, module)
    if match := _MISSING_ARGUMENT.search(text):
        words = " or ".join(other_words(match[1]))
        return f"write {match[1]}=...{f', not {words}' if words else ''}"
    if fitting := [advised for pattern, advised in _ADVICE if pattern.search(text)]:
        return fitting[0]
    if isinstance(error, AttributeError) and error.name and error.obj is not None:
        is_module = isinstance(error.obj, ModuleType)
        imported = _import_of(error.name) if is_module else ""
        return imported or did_you_mean(error.name, _public(error.obj))
    return ""


def _unset_variable(error: BaseException) -> str:
    """Return the environment variable whose absence raised an error, or an empty string."""
    frames = traceback.extract_tb(error.__traceback__)
    if isinstance(error, KeyError) and frames and frames[-1].filename in _OS_FILES:
        return str(error.args[0])
    if "NoneType" not in str(error):
        return ""
    read = (match[2] for frame in frames for match in _READ_VARIABLE.finditer(frame.line or ""))
    return next((name for name in read if name not in os.environ), "")


def _without_value(name: str, text: str) -> str:
    """Return what to write in place of code that needs the value of a substitution."""
    if "for +" in text or "concatenate" in text:
        return f"write a list in place of `+`: [{name}(...), 'text']"
    if "PathLike" in text:
        return f"write PathJoinSubstitution([{name}(...), 'file']) in place of os.path.join"
    return f"the launch knows the value of {name} later: use an OpaqueFunction and its context"


def corrected_import(text: str) -> tuple[str, str]:
    """Return the sentence and the hint for the text of zbot's error about a wrong import.

    A class of `launch` may be imported from `launch_ros`, and the other way round. The error of the
    import looks only into one of them.
    """
    match = _WRONG_CLASS.match(text)
    hint = _import_of(match[1]) or _similar_of(match[1], match[2]) if match else ""
    return (match[0], hint) if match and hint else (text, "")


def missing_function(module: ModuleType) -> str:
    """Return what to do about a launch file without the function."""
    functions = filter(inspect.isfunction, vars(module).values())
    own = [function.__name__ for function in functions if function.__module__ == module.__name__]
    if "generate_test_description" in own:
        return f"the file is a test: type `zbot test {module.__file__}`"
    if near := similar_names(FUNCTION, own):
        return f"rename {near[0]}() to {FUNCTION}()"
    if callable(getattr(module, "main", None)):
        return "the file is a program: start it with `zbot run`"
    return f"write: def {FUNCTION}():"


def _import_of(name: str) -> str:
    for module in _MODULES:
        if name in _public(importlib.import_module(module)):
            return f"write: from {module} import {name}"
    return ""


def _similar_of(name: str, module: str) -> str:
    if module in _MODULES:
        return did_you_mean(name, _public(importlib.import_module(module)))
    near = (
        similar_names(name, _public(importlib.import_module(module_name)))
        for module_name in _MODULES
    )
    return question(next(filter(None, near), ()))


def _public(place: object) -> Iterable[str]:
    return [name for name in dir(place) if not name.startswith("_")]
