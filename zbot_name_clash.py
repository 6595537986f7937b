"""Warning about a file of the program that has the name of a module, e.g. `queue.py`.

Python searches the program's folder first. So the file replaces the module, also for other modules.
These modules then fail in places that the student does not know.

`zbot_ros2_names` imports this module when a program imports zbot or a name of ROS 2. `zbot run`
imports it too. The module must import only modules that Python has loaded at its start, because the
program's folder may replace all others.

PYTEST_DONT_REWRITE tells pytest not to warn that it cannot rewrite the assertions of this module.
"""

import os
import sys

#: Libraries that zbot needs. A file of the program may replace them too.
_LIBRARIES = ("cryptography", "ifaddr", "msgpack", "numpy", "typer", "yaml", "zbot", "zenoh")
_PACKAGES = os.path.join(os.path.dirname(__file__), "zbot", "compat", "packages")  # noqa: PTH118, PTH120 - pathlib would be imported
_DEFINITIONS = os.path.join(os.path.dirname(__file__), "zbot", "interfaces", "defs")  # noqa: PTH118, PTH120 - as above


class ClashFinder:
    """Finder for `sys.meta_path` that warns when a file of the program replaces a module.

    If this file is the program itself, the import gets the module that the file hides.

    Args:
        clashes: The files, by the name of the module that each replaces.
    """

    def __init__(self, clashes: "dict[str, str]") -> None:
        self._clashes = clashes

    def find_spec(self, name, path=None, target=None):  # type: ignore[no-untyped-def]  # noqa: ANN001, ANN201 - `typing` would be imported
        """Warn if a top-level module has the name of one of the files. Find only hidden modules."""
        file = self._clashes.pop(name, None) if path is None else None
        if file is None:
            return None
        _warn(name, file)
        if not _is_program(file):
            return None
        hidden = [one for one in sys.path if _same(one or os.curdir, os.path.dirname(file))]  # noqa: PTH120 - as above
        before, sys.path[:] = sys.path[:], [one for one in sys.path if one not in hidden]
        try:
            for finder in sys.meta_path:
                spec = finder.find_spec(name, None, target)
                if spec is not None:
                    return spec
        finally:
            sys.path[:] = before
        return None


def watch(folders: "list[str]") -> None:
    """Warn from now on when a file of these folders replaces a module.

    Args:
        folders: The folders that Python searches first.
    """
    clashes: dict[str, str] = {}
    for folder in reversed(folders):
        clashes.update(_clashing_files(folder))
    for name in [name for name in clashes if name in sys.modules]:
        file = clashes.pop(name)
        if _same(getattr(sys.modules[name], "__file__", None) or "", file):
            _warn(name, file)
    if clashes:
        sys.meta_path.insert(0, ClashFinder(clashes))


def _clashing_files(folder: str) -> "dict[str, str]":
    if _same(folder or os.curdir, os.path.dirname(os.__file__)):  # noqa: PTH120 - as above
        return {}  # Python's own library
    try:
        found = os.listdir(folder or os.curdir)  # noqa: PTH208 - as above
    except OSError:
        return {}
    clashes = {}
    for entry in found:
        name, dot, ending = entry.partition(".")
        is_module = ending == "py"
        if not (is_module or not dot) or not _is_taken(name, is_module=is_module):
            continue
        file = os.path.join(folder, entry, *(() if is_module else ("__init__.py",)))  # noqa: PTH118 - as above
        if is_module or os.path.isfile(file):  # noqa: PTH113 - as above
            clashes[name] = file
    return clashes


def _is_taken(name: str, *, is_module: bool) -> bool:
    """Return whether a module has this name, and Python searches for it in the program's folder."""
    if name in sys.stdlib_module_names:
        import _imp  # noqa: PLC0415 - part of Python

        return name not in sys.builtin_module_names and not _imp.is_frozen(name)
    # A package of a workspace may have its own folder `launch` or `my_msgs`.
    ours = (os.path.join(_PACKAGES, name), os.path.join(_DEFINITIONS, name))  # noqa: PTH118 - as above
    return is_module and (name in _LIBRARIES or any(map(os.path.isdir, ours)))


def _is_program(file: str) -> bool:
    program = getattr(sys.modules.get("__main__"), "__file__", None)
    return program is not None and _same(program, file)


def _same(first: str, second: str) -> bool:
    try:
        return os.path.samefile(first, second)  # noqa: PTH121 - as above
    except OSError:
        return False


def _warn(name: str, file: str) -> None:
    owner = "Python's module" if name in sys.stdlib_module_names else "the module"
    print(f"the file {os.path.abspath(file)} hides {owner} {name}: rename it", file=sys.stderr)  # noqa: PTH100 - as above
