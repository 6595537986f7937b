"""Environment of a launch, which is that of its process as in ROS 2.

So launch files in Python read what `SetEnvironmentVariable` sets, and programs get what the code of
a launch file puts into `os.environ`.
"""

from __future__ import annotations

import os
from collections.abc import MutableMapping
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping


class Environment(MutableMapping[str, str]):
    """The variables of this process. `undo` takes back what was changed through this object."""

    def __init__(self) -> None:
        self._first = dict(os.environ)
        self._before: dict[str, str | None] = {}

    def __getitem__(self, name: str) -> str:
        return os.environ[name]

    def __setitem__(self, name: str, value: str) -> None:
        self._before.setdefault(name, os.environ.get(name))
        os.environ[name] = value

    def __delitem__(self, name: str) -> None:
        self._before.setdefault(name, os.environ.get(name))
        del os.environ[name]

    def __iter__(self) -> Iterator[str]:
        return iter(os.environ)

    def __len__(self) -> int:
        return len(os.environ)

    def replace(self, variables: Mapping[str, str]) -> None:
        """Set these variables, and remove all others."""
        for name in set(self) - set(variables):
            del self[name]
        for name, value in variables.items():
            if self.get(name) != value:
                self[name] = value

    def reset(self) -> None:
        """Restore the variables with which the launch was created."""
        self.replace(self._first)

    def undo(self) -> None:
        """Restore the variables that this object has changed, and no others."""
        while self._before:
            name, value = self._before.popitem()
            if value is not None:
                os.environ[name] = value
            else:
                os.environ.pop(name, None)


def how_to_set(name: str) -> str:
    """Return what to type to set an environment variable that a launch file needs."""
    line = f"$env:{name} = 'VALUE'" if os.name == "nt" else f"export {name}=VALUE"
    return f"set the environment variable first: type `{line}`"
