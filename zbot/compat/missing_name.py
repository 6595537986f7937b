"""Finder that explains wrong imports from ROS 2's packages, such as `from rclpy import Node`."""

from __future__ import annotations

import re
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from zbot.errors import ZbotError
from zbot.errors.suggestion import question, similar_names
from zbot.interfaces.finder import is_import_statement

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence
    from types import ModuleType

_PACKAGES = Path(__file__).parent / "packages"


class WrongImportError(ZbotError, ModuleNotFoundError):
    """A program imports a name that a package of ROS 2 does not have."""

    def __init__(self, package: str, name: str, text: str) -> None:
        super().__init__(f"cannot import {name!r} from {package!r}{text}")
        # With the module's full name, `from package import name` would drop this error.
        self.name = package


class WrongImportFinder:
    """The last finder. It finds nothing, and raises the error for a name of zbot's packages."""

    @staticmethod
    def find_spec(
        fullname: str, path: Sequence[str] | None, target: ModuleType | None = None
    ) -> None:
        """Raise an error that says what to write.

        Raises:
            WrongImportError: The module does not exist in a package that zbot has.
        """
        del target
        package, _, name = fullname.rpartition(".")
        if path is None or not any(str(one).startswith(str(_PACKAGES)) for one in path):
            return
        if not name.startswith("_") and is_import_statement():
            raise WrongImportError(package, name, _advice(package.partition(".")[0], name))


def _advice(package: str, name: str) -> str:
    modules = dict(_modules(_PACKAGES / package, package))
    last_part = {module.rpartition(".")[2]: module for module in modules}
    near = tuple(last_part[one] for one in similar_names(name, last_part))
    if not name.islower():  # a class
        classes = {one for text in modules.values() for one in re.findall(r"\b[A-Z]\w+", text)}
        name = name if name in classes else next(iter(similar_names(name, classes)), name)
    holders = [module for module, text in modules.items() if re.search(rf"\b{name}\b", text)]
    if not holders or (near and name.islower()):
        return question(near, "; ")
    # `rclpy.duration` comes before `rclpy.qos`, and `launch.actions` before `launch.events`.
    best = last_part.get(name.lower()) or min(holders, key=lambda one: ("event" in one, len(one)))
    return f": write from {best} import {name}"


def _modules(folder: Path, package: str) -> Iterator[tuple[str, str]]:
    """Yield each module of a package, with its source without the words of its first line."""
    for file in sorted(folder.rglob("*.py")):
        parts = file.relative_to(folder).with_suffix("").parts
        parts = parts[:-1] if parts[-1] == "__init__" else parts
        module = ".".join((package, *parts))
        if parts and not parts[-1].startswith("_"):
            yield module, file.read_text(encoding="utf-8").partition('"""\n')[2]


def install() -> None:
    """Put the finder after all others. A second call does nothing."""
    if WrongImportFinder not in sys.meta_path:
        sys.meta_path.append(WrongImportFinder)
