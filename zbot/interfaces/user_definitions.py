"""Store of the definitions that the user has added with `zbot interface add`.

All projects of the user share this store.
"""

from __future__ import annotations

import os
import shutil
from typing import TYPE_CHECKING

from zbot.errors import WrongValueError, ZbotError
from zbot.interfaces.location import package_folder, packages_in
from zbot.interfaces.parser import parse
from zbot.interfaces.spec import MessageSpec, parts_of
from zbot.package.user_folders import definitions_folder, make_private

if TYPE_CHECKING:
    from collections.abc import Iterator

    from zbot.interfaces.collection import FoundPackage
    from zbot.interfaces.spec import InterfaceSpec


class StoreError(ZbotError, OSError):
    """The folder of the added definitions cannot be changed."""

    def __init__(self, package: str, reason: OSError | str) -> None:
        self.package = package
        text = (reason.strerror or str(reason)) if isinstance(reason, OSError) else reason
        super().__init__(f"cannot store the definitions of {package}: {text}")


def check(package: FoundPackage) -> set[str]:
    """Check all definitions of a package. Return the missing packages that these definitions use.

    Raises:
        InterfaceSyntaxError: A definition is wrong. The error has its file and line.
    """
    used: set[str] = set()
    for path, text in package.texts.items():
        name = f"{package.name}/{path.rpartition('.')[0]}"
        spec = parse(name, text, f"{package.place}/{path}")
        for message in _messages(spec):
            kinds = [field.type for field in message.fields]
            used |= {kind.base.split("/")[0] for kind in kinds if kind.is_message}
    return {name for name in used - {package.name} if package_folder(name) is None}


def store(package: FoundPackage) -> None:
    """Copy the definitions of a package into the store, in place of its earlier definitions.

    Raises:
        StoreError: The files cannot be written.
    """
    folder = definitions_folder()
    # Whole folders are renamed, so other programs never see only a part of the definitions.
    new, old = (folder / f".{package.name}.{os.getpid()}.{word}" for word in ("new", "old"))
    try:
        for path, text in package.texts.items():
            file = new / path
            make_private(file.parent)
            file.write_bytes(text.encode())
        if (folder / package.name).exists():
            (folder / package.name).rename(old)
        new.rename(folder / package.name)
    except OSError as error:
        raise StoreError(package.name, error) from error
    finally:
        for left in (new, old):
            shutil.rmtree(left, ignore_errors=True)


def remove(package: str) -> None:
    """Remove the definitions of a package from the store.

    Raises:
        WrongValueError: The package is not in the store.
        StoreError: The files cannot be removed.
    """
    known = added_packages()
    folder = definitions_folder()
    if package not in known:
        hint = f"the added packages are: {', '.join(known)}" if known else ""
        raise WrongValueError(f"'{package}' was not added with `zbot interface add`", hint=hint)
    try:
        shutil.rmtree(folder / package)
    except OSError as error:
        raise StoreError(package, error) from error


def added_packages() -> list[str]:
    """Return the names of the packages in the store, sorted."""
    return packages_in(definitions_folder())


def _messages(spec: InterfaceSpec) -> Iterator[MessageSpec]:
    if isinstance(spec, MessageSpec):
        yield spec
    for part in parts_of(spec):
        yield from _messages(part)
