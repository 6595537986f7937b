"""Loaders of modules such as `std_msgs`, `std_msgs.msg` and `std_msgs.msg._string`."""

from __future__ import annotations

import sys
from functools import partial
from importlib import import_module
from importlib.machinery import ModuleSpec
from types import ModuleType
from typing import TYPE_CHECKING, Any

from zbot.errors.suggestion import question, similar_names
from zbot.interfaces import registry
from zbot.interfaces.classes import module_name
from zbot.interfaces.errors import (
    InterfaceImportError,
    UnknownInterfaceError,
)
from zbot.interfaces.registry import has_package
from zbot.interfaces.spec import ActionSpec, ServiceSpec
from zbot.names import KINDS

if TYPE_CHECKING:
    from importlib.abc import Loader
else:
    Loader = object  # importlib.abc would load tempfile, random and more


def package_spec(package: str) -> ModuleSpec | None:
    """Return the spec of a package, e.g. `std_msgs`, or `None` if it has no definitions."""
    known = has_package(package)
    return ModuleSpec(package, _PackageLoader(), is_package=True) if known else None


def kind_spec(package: str, kind: str) -> ModuleSpec | None:
    """Return the spec of a module such as `std_msgs.msg`, or `None` if there are no definitions."""
    names = _interfaces(package, kind)
    return ModuleSpec(f"{package}.{kind}", _KindLoader(names), is_package=True) if names else None


def submodule_spec(fullname: str) -> ModuleSpec | None:
    """Return the spec of e.g. `std_msgs.msg._string`, or `None` if zbot did not make its parent.

    Raises:
        ImportError: `_KindModule.find_submodule` describes this error.
    """
    parent, _, last = fullname.rpartition(".")
    module = sys.modules.get(parent)
    return module.find_submodule(fullname, last) if isinstance(module, _KindModule) else None


def missing_module(package: str, inside: str) -> ModuleNotFoundError | None:
    """Return the error for the import of e.g. `std_msgs.String`, if zbot made the package."""
    module = sys.modules.get(package)
    if not isinstance(getattr(module, "__loader__", None), _PackageLoader):
        return None
    kind = inside.partition(".")[0]
    if kind in KINDS and _interfaces(package, kind):  # the kind is right
        return None
    from zbot.interfaces.missing_import import text_for_module  # noqa: PLC0415 - needed only after an error

    return InterfaceImportError(package, text_for_module(package, inside))


def missing_package(package: str) -> InterfaceImportError:
    """Return the error for the import of a package that has no definitions here."""
    from zbot.interfaces.missing_import import (  # noqa: PLC0415 - needed only after an error
        how_to_add,
        repository_of,
    )

    if repository_of(package):  # the name is right
        return _missing(package, how_to_add(package))
    if not package.endswith("s"):  # e.g. std_msg
        near = similar_names(package, registry.packages())
        return _missing(package, "" if near else how_to_add(package), near)
    # Many names have the same ending, so only their beginnings are compared.
    known = {name.rpartition("_")[0]: name for name in registry.packages()}
    near = similar_names(package.rpartition("_")[0], known)
    suggestions = tuple(known[beginning] for beginning in near)
    return _missing(package, how_to_add(package), suggestions)


def _missing(
    package: str, how_to_add: str, suggestions: tuple[str, ...] = ()
) -> InterfaceImportError:
    near = question(suggestions, "; ") or "."
    way = f" To add the package, {how_to_add}" if how_to_add else ""
    return InterfaceImportError(package, f"No module named {package!r}{near}{way}")


class _PackageLoader(Loader):
    """Loader of an empty package such as `std_msgs`."""

    def create_module(self, spec: ModuleSpec) -> ModuleType | None:
        """Return None, so that Python creates the module."""
        del spec
        return None

    def exec_module(self, module: ModuleType) -> None:
        package = module.__name__
        module.__doc__ = f"Interfaces of {package}, made by zbot from their definitions."
        # In ROS 2, `import std_msgs` is enough for `std_msgs.msg` if any other module has imported
        # `std_msgs.msg`. The generated classes of other packages often do this.
        module.__dict__["__getattr__"] = partial(_kind_module, package)


def _kind_module(package: str, kind: str) -> ModuleType:
    """Return e.g. `std_msgs.msg`, and import it if necessary."""
    if kind in KINDS and _interfaces(package, kind):
        return import_module(f"{package}.{kind}")
    if kind.startswith("_"):  # Python's own look-ups
        raise AttributeError(f"module {package!r} has no attribute {kind!r}")
    from zbot.interfaces.missing_import import text_for_module  # noqa: PLC0415 - needed only after an error

    raise AttributeError(text_for_module(package, kind), name="")  # Python suggests nothing


class _KindLoader(Loader):
    """Loader of a module such as `std_msgs.msg`, whose classes are made at the first access."""

    def __init__(self, names: dict[str, str]) -> None:
        self._names = names

    def create_module(self, spec: ModuleSpec) -> ModuleType:
        return _KindModule(spec.name, self._names)

    def exec_module(self, module: ModuleType) -> None:
        module.__doc__ = f"Classes of {module.__name__}, made by zbot from their definitions."


class _ModuleLoader(Loader):
    """Loader of a module such as `std_srvs.srv._set_bool`: a class and the classes of its parts."""

    def __init__(self, name: str) -> None:
        self._name = name

    def create_module(self, spec: ModuleSpec) -> ModuleType | None:
        """Return None, so that Python creates the module."""
        del spec
        return None

    def exec_module(self, module: ModuleType) -> None:
        for name in _parts(self._name):
            setattr(module, name.rpartition("/")[2], registry.get_interface(name))


class _KindModule(ModuleType):
    """Module whose attributes are classes from the registry."""

    def __init__(self, name: str, names: dict[str, str]) -> None:
        super().__init__(name)
        self._names = names
        self.__all__ = sorted(names)  # the names that `import *` imports

    def __getattr__(self, attribute: str) -> Any:
        if attribute.startswith("_"):  # Python's own look-ups, e.g. of __file__
            raise AttributeError(f"module {self.__name__!r} has no attribute {attribute!r}")
        # SetBool_Request is a part of SetBool.
        owner = self._names.get(attribute.partition("_")[0])
        if owner is None:
            raise AttributeError(self._missing(attribute), name="")  # Python suggests nothing
        try:
            cls = registry.get_interface(f"{owner.rpartition('/')[0]}/{attribute}")
        except UnknownInterfaceError:
            raise AttributeError(self._missing(attribute), name="") from None
        setattr(self, attribute, cls)
        return cls

    def __dir__(self) -> list[str]:
        return sorted({*super().__dir__(), *self._names})

    def find_submodule(self, fullname: str, last: str) -> ModuleSpec | None:
        """Return the spec of ROS 2's module for an interface, e.g. `_set_bool` for SetBool.

        Raises:
            ImportError: The name is wrong, e.g. `from std_msgs.msg import Strng`. Python looks for
                a module if the attribute is missing. Python's own error would suggest no name.
        """
        if not last.startswith("_"):
            raise ImportError(self._missing(last), name=fullname)
        defined = [name for name in self._names.values() if module_name(name) == fullname]
        return ModuleSpec(fullname, _ModuleLoader(defined[0])) if defined else None

    def _missing(self, attribute: str) -> str:
        from zbot.interfaces import missing_import  # noqa: PLC0415 - needed only after an error

        package, _, kind = self.__name__.partition(".")
        if attribute in self._names:
            return missing_import.text_for_class(package, kind, attribute)
        return missing_import.text_for_name(package, kind, attribute)


def _interfaces(package: str, kind: str) -> dict[str, str]:
    """Return a dictionary from class names to full names for one kind of a package's interfaces."""
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
