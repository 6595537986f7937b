"""`from std_msgs.msg import String`, without a package std_msgs on disk.

The modules of a real ROS 2 win. What is missing is filled in: whole packages, and `msg`, `srv`,
`action` in a real Python package that has no such module.
"""

from __future__ import annotations

import sys
from importlib.machinery import ModuleSpec
from types import ModuleType
from typing import TYPE_CHECKING, Any

from zbot.errors import UnknownInterfaceError, nearest
from zbot.interfaces import registry
from zbot.interfaces.classes import module_name
from zbot.interfaces.spec import ActionSpec, ServiceSpec
from zbot.interfaces.workspace import KINDS

if TYPE_CHECKING:
    from collections.abc import Sequence
    from importlib.abc import Loader
else:
    Loader = object  # importlib.abc would load tempfile, random and more


def install_importer() -> None:
    """Make every known definition importable as in ROS 2; calling it again changes nothing."""
    if not any(isinstance(finder, _KindFinder) for finder in sys.meta_path):
        sys.meta_path.insert(0, _KindFinder())
        sys.meta_path.append(_PackageFinder())


class _KindFinder:
    """Finds `std_msgs.msg`, unless there is a real module.

    It stands first on `sys.meta_path`: to Python, a folder `my_package/msg` of .msg files is a
    namespace package, which would be found before anything at the end of the list is asked.
    """

    def find_spec(
        self, fullname: str, path: Sequence[str] | None, target: ModuleType | None = None
    ) -> ModuleSpec | None:
        """Return a spec if a package has definitions of that kind, and no module of its own."""
        package, _, kind = fullname.partition(".")
        if kind not in KINDS or not registry.has_package(package):
            return None
        others = (finder for finder in sys.meta_path if finder is not self)
        found = (finder.find_spec(fullname, path, target) for finder in others)
        if any(spec is not None and spec.origin is not None for spec in found):
            return None
        names = _interfaces(package, kind)
        return ModuleSpec(fullname, _KindLoader(names), is_package=True) if names else None


class _PackageFinder:
    """Finds `std_msgs` and `std_msgs.msg._string`, last, when there is nothing real."""

    def find_spec(
        self, fullname: str, path: Sequence[str] | None, target: ModuleType | None = None
    ) -> ModuleSpec | None:
        """Return a spec if the name stands for definitions that are known here."""
        del path, target
        parent, _, last = fullname.rpartition(".")
        if not parent:
            known = registry.has_package(fullname)
            return ModuleSpec(fullname, _PackageLoader(), is_package=True) if known else None
        module = sys.modules.get(parent)
        return module.find_below(fullname, last) if isinstance(module, _KindModule) else None


class _PackageLoader(Loader):
    """A package that holds nothing itself, like `std_msgs`."""

    def create_module(self, spec: ModuleSpec) -> ModuleType | None:
        """Leave it to Python."""
        del spec
        return None

    def exec_module(self, module: ModuleType) -> None:
        package = module.__name__
        module.__doc__ = f"Interfaces of {package}, made by zbot from their definitions."


class _KindLoader(Loader):
    """A module like `std_msgs.msg`: its classes are made when they are first asked for."""

    def __init__(self, names: dict[str, str]) -> None:
        self._names = names

    def create_module(self, spec: ModuleSpec) -> ModuleType:
        return _KindModule(spec.name, self._names)

    def exec_module(self, module: ModuleType) -> None:
        module.__doc__ = f"Classes of {module.__name__}, made by zbot from their definitions."


class _ModuleLoader(Loader):
    """A module like `std_srvs.srv._set_bool`: a class and those of its parts."""

    def __init__(self, name: str) -> None:
        self._name = name

    def create_module(self, spec: ModuleSpec) -> ModuleType | None:
        """Leave it to Python."""
        del spec
        return None

    def exec_module(self, module: ModuleType) -> None:
        for name in _parts(self._name):
            setattr(module, name.rpartition("/")[2], registry.get_interface(name))


class _KindModule(ModuleType):
    """Looks its attributes up in the registry."""

    def __init__(self, name: str, names: dict[str, str]) -> None:
        super().__init__(name)
        self._names = names
        self.__all__ = sorted(names)  # what `import *` takes

    def __getattr__(self, attribute: str) -> Any:
        if attribute.startswith("_"):  # Python's own questions, e.g. for __file__
            raise AttributeError(f"module {self.__name__!r} has no attribute {attribute!r}")
        # SetBool_Request is a part of SetBool.
        owner = self._names.get(attribute.partition("_")[0])
        if owner is None:
            raise AttributeError(self._missing(attribute))
        try:
            cls = registry.get_interface(f"{owner.rpartition('/')[0]}/{attribute}")
        except UnknownInterfaceError:
            raise AttributeError(self._missing(attribute)) from None
        setattr(self, attribute, cls)
        return cls

    def __dir__(self) -> list[str]:
        return sorted({*super().__dir__(), *self._names})

    def find_below(self, fullname: str, last: str) -> ModuleSpec | None:
        """Return the spec of `_set_bool`, which ROS 2 has for SetBool.

        Raises:
            ImportError: `from std_msgs.msg import Strng`: Python asks for a module of that name
                when there is no attribute, and its own message would have no suggestion.
        """
        if not last.startswith("_"):
            raise ImportError(self._missing(last), name=fullname)
        defined = [name for name in self._names.values() if module_name(name) == fullname]
        return ModuleSpec(fullname, _ModuleLoader(defined[0])) if defined else None

    def _missing(self, attribute: str) -> str:
        near = nearest(attribute, self._names, 1)
        hint = f"; did you mean {near[0]!r}?" if near else ""
        return f"cannot import name {attribute!r} from {self.__name__!r}{hint}"


def _interfaces(package: str, kind: str) -> dict[str, str]:
    """Class names and full names of a package's interfaces of one kind."""
    names = registry.interface_names(package)
    return {name.rpartition("/")[2]: name for name in names if name.split("/")[1] == kind}


def _parts(name: str) -> list[str]:
    spec = registry.get_spec(name)
    if isinstance(spec, ServiceSpec):
        return [name, spec.request.name, spec.response.name, spec.event.name]
    if isinstance(spec, ActionSpec):
        messages = (spec.goal, spec.result, spec.feedback, spec.feedback_message)
        services = [*_parts(spec.send_goal.name), *_parts(spec.get_result.name)]
        return [name, *(message.name for message in messages), *services]
    return [name]
