"""Finder of modules for `sys.meta_path`, with all sources of modules that zbot has.

`ORDER` says which source wins: a module comes from the first source that has it. The sources before
`PYTHON` are asked before Python's own finders, because a folder without `__init__.py` is a package
for these: Python would take `launch/` in the current folder for the package `launch`, and
`my_package/msg/` for the module `my_package.msg`. Each of these sources looks itself for a real
module, which wins. The sources after `PYTHON` are asked only if no other finder has the module.

Python asks the finder at every import, so this module is small and a source loads what it needs
when it needs it. `zbot_ros2_names` and `zbot_name_clash` have finders of their own: they run before
`import zbot`, and must not import it in programs that do not use it.

If a genuine ROS 2 is installed beside zbot, its packages win over zbot's packages of the same
names. `prefer_zbot()` reverses this for a process. The environment variable ZBOT_RCLPY does so for
a process and its child processes. `zbot run`, `zbot launch` and `zbot test` set this variable.
"""

from __future__ import annotations

import os
import sys
from importlib.machinery import PathFinder
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from importlib.machinery import ModuleSpec
    from types import ModuleType

    #: Function that has the arguments and the result of a finder's `find_spec`.
    Source = Callable[[str, Sequence[str] | None, ModuleType | None], ModuleSpec | None]
    #: Function that returns the error for a module that does not exist, or None. It gets the
    #: module's name, and the path of the package of which the module would be a part.
    Explanation = Callable[[str, Sequence[str] | None], BaseException | None]

PYTHON = "all other finders, e.g. those for installed packages and for the files of a program"
ORDER = (
    "ROS 2's names",  # `rclpy`, if there is no real one or zbot's is preferred: zbot.compat
    "interfaces",  # `std_msgs.msg`, with the same condition: zbot.interfaces
    "workspace",  # Python packages that are not installed: zbot.package
    PYTHON,
    "packages of interfaces",  # `std_msgs`, and `std_msgs.msg._string`: zbot.interfaces
)


class ImportFinder:
    """Finder that asks its sources in their order.

    Attributes:
        sources: The sources by their names in `ORDER`.
        explanations: Functions that are asked for an error if no source has a module.
    """

    def __init__(self) -> None:
        self.sources: dict[str, Source] = {}
        self.explanations: list[Explanation] = []

    def find_spec(
        self,
        fullname: str,
        path: Sequence[str] | None = None,
        target: ModuleType | None = None,
    ) -> ModuleSpec | None:
        """Return the spec of a module from the first source that has it.

        Raises:
            ImportError: A program imports a module that does not exist, and zbot can say what to
                write. A program that only asks with `importlib.util.find_spec` gets None.
        """
        for source in self.sources.values():
            spec = source(fullname, path, target)
            if spec is not None:
                return spec
        if self.explanations and _is_import_statement():
            errors = (explanation(fullname, path) for explanation in self.explanations)
            error = next(filter(None, errors), None)
            if error is not None and not self._has_a_later_finder(fullname, path, target):
                raise error
        return None

    def _has_a_later_finder(
        self, fullname: str, path: Sequence[str] | None, target: ModuleType | None
    ) -> bool:
        later = sys.meta_path[sys.meta_path.index(self) + 1 :]
        return any(finder.find_spec(fullname, path, target) for finder in later)


_first, _last = ImportFinder(), ImportFinder()
#: Environment variable that says whose `rclpy` programs import: `zbot` or `genuine`.
VARIABLE = "ZBOT_RCLPY"
_prefers_zbot = os.environ.get(VARIABLE) == "zbot"


def prefers_zbot() -> bool:
    """Return whether zbot's packages win over the packages of an installed ROS 2."""
    return _prefers_zbot


def prefer_zbot(wanted: bool = True) -> None:
    """Let zbot's packages win over the packages of an installed ROS 2 in this process, or not."""
    global _prefers_zbot  # noqa: PLW0603 - there is one order per process
    _prefers_zbot = wanted


def add(name: str, source: Source) -> None:
    """Search a source from now on. A second call has no effect.

    Args:
        name: One of `ORDER`. The order of the calls does not matter.
        source: The function that finds modules.
    """
    finder = _first if ORDER.index(name) < ORDER.index(PYTHON) else _last
    found = {**finder.sources, name: source}
    finder.sources = {source: found[source] for source in ORDER if source in found}
    _install()


def explain(explanation: Explanation) -> None:
    """Ask a function for errors from now on, after the functions before. Not a second time."""
    if explanation not in _last.explanations:
        _last.explanations.append(explanation)
    _install()


def stop_explaining(explanation: Explanation) -> None:
    """Do not ask the function any longer."""
    if explanation in _last.explanations:
        _last.explanations.remove(explanation)


def _install() -> None:
    if _first not in sys.meta_path:
        sys.meta_path.insert(0, _first)
    if _last not in sys.meta_path:
        sys.meta_path.append(_last)


def is_real(spec: ModuleSpec | None) -> bool:
    """Return whether there is a module with code. A folder without `__init__.py` has none."""
    return spec is not None and spec.origin is not None


def is_installed(
    fullname: str, path: Sequence[str] | None = None, *, among: Sequence[str] | None = None
) -> bool:
    """Return whether a finder that is not zbot's has a real module.

    Args:
        fullname: The module's name.
        path: The path of the package of which the module is a part. None for a top-level module.
        among: The folders that Python's own finder searches in place of `path`.
    """
    return installed_spec(fullname, path, among=among) is not None


def installed_spec(
    fullname: str, path: Sequence[str] | None = None, *, among: Sequence[str] | None = None
) -> ModuleSpec | None:
    """Return the spec of a real module of a finder that is not zbot's, or None. See above."""
    for finder in sys.meta_path:
        if not isinstance(finder, ImportFinder):
            where = path if among is None or finder is not PathFinder else among
            spec = finder.find_spec(fullname, where)
            if is_real(spec):
                return spec
    return None


def _is_import_statement() -> bool:
    """Return whether Python imports a module. `importlib.util.find_spec` only asks for one."""
    # The callers: find_spec, importlib's _find_spec, and the function that called it. At the first
    # import of a name of ROS 2, two functions of `zbot_ros2_names` are between the first two.
    is_first = sys._getframe(2).f_code.co_name == "_spec_of_zbot"  # noqa: SLF001 - documented
    caller = sys._getframe(5 if is_first else 3)  # noqa: SLF001 - as above
    return caller.f_code.co_name == "_find_and_load_unlocked"
