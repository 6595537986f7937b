"""Attribute that `__init__` sets. Its use in a subclass that did not call `super().__init__()`."""

from __future__ import annotations

from typing import Any

from zbot.errors import ZbotError


class MissingSuperInitError(ZbotError, AttributeError):
    """A subclass uses a method of its base class before it called `super().__init__()`."""

    def __init__(self, cls: type[Any], arguments: str) -> None:
        self.cls = cls
        base = next(base for base in cls.__mro__ if base.__module__.startswith("zbot."))
        # Without a `name`, Python would add one, and suggest private attributes.
        AttributeError.__init__(
            self,
            f"{cls.__name__} has not called {base.__name__}.__init__ yet: "
            f"begin {cls.__name__}.__init__ with super().__init__({arguments})",
            name="",
        )


def set_by_init(arguments: str = "") -> Any:
    """Return the value of a class attribute that `__init__` sets for each object.

    Args:
        arguments: The arguments of `super().__init__`, as the error shows them.
    """
    return _SetByInit(arguments)


class _SetByInit:
    """Descriptor for an attribute of instances. The instance's own value replaces it.

    Reading a value that exists takes about 30 ns more. So no attribute that is read for each
    message has this descriptor.
    """

    def __init__(self, arguments: str) -> None:
        self._arguments = arguments

    def __get__(self, owner: Any, cls: type[Any]) -> Any:
        if owner is None:  # read on the class, e.g. by inspect.getmembers
            return self
        raise MissingSuperInitError(type(owner), self._arguments)
