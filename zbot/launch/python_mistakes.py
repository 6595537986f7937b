"""Advice for errors that Python raises in a launch file: what to write instead."""

from __future__ import annotations

import importlib
import inspect
import re
from typing import TYPE_CHECKING

from zbot.errors.suggestion import did_you_mean, question, similar_names
from zbot.launch.argument_names import other_words

if TYPE_CHECKING:
    from collections.abc import Iterable
    from types import ModuleType

FUNCTION = "generate_launch_description"
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
_TOO_MANY = re.compile(r"LaunchDescription\.__init__\(\) takes from 1 to 2 positional arguments")
_OF_RCLPY = re.compile(r"Node\.__init__\(\) got an unexpected keyword argument '(package|exec\w*)'")
_TAKES_ARGUMENTS = re.compile(rf"{FUNCTION}\(\) missing \d+ required positional")


def advice(error: Exception | SystemExit) -> str:
    """Return what to write in place of the code that raised an error, or an empty string."""
    text = str(error)
    if isinstance(error, ModuleNotFoundError):
        return did_you_mean(error.name or "", [*_MODULES, "launch_ros", "ament_index_python"])
    if match := _NO_NAME.search(text) or _UNDEFINED.search(text):
        name, module = match[1], match[2] if match.re is _NO_NAME else ""
        return _import_of(name) or _similar_of(name, module)
    if match := _MISSING_ARGUMENT.search(text):
        words = " or ".join(other_words(match[1]))
        return f"write {match[1]}=...{f', not {words}' if words else ''}"
    if _TOO_MANY.search(text):
        return "put the actions into a list: LaunchDescription([...])"
    if _OF_RCLPY.search(text):
        return "write: from launch_ros.actions import Node"
    if _TAKES_ARGUMENTS.search(text):
        return f"write: def {FUNCTION}():"
    if isinstance(error, AttributeError) and error.name and error.obj is not None:
        return did_you_mean(error.name, _public(error.obj))
    return ""


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
    own = [one.__name__ for one in functions if one.__module__ == module.__name__]
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
    near = (similar_names(name, _public(importlib.import_module(one))) for one in _MODULES)
    return question(next(filter(None, near), ()))


def _public(place: object) -> Iterable[str]:
    return [name for name in dir(place) if not name.startswith("_")]
