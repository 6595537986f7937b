"""Check of the message, service and action definitions of a package."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING

from zbot.errors.suggestion import did_you_mean
from zbot.interfaces import interface_names
from zbot.interfaces.errors import InterfaceSyntaxError
from zbot.interfaces.parser import parse
from zbot.interfaces.spec import ActionSpec, MessageSpec, ServiceSpec
from zbot.names import KINDS
from zbot.package.cmake_file import read_cmake
from zbot.package.errors import SetupFileError
from zbot.package.workspace import MANIFEST
from zbot_cli.packages.check.checked_package import Problem

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path

    from zbot.interfaces.spec import Field, InterfaceSpec
    from zbot_cli.packages.check.checked_package import CheckedPackage

_GROUP = "rosidl_interface_packages"


def check_interfaces(checked: CheckedPackage) -> Iterator[Problem]:
    """Yield the problems of a package's definitions, CMakeLists.txt and package.xml."""
    files = [path for kind in KINDS for path in sorted((checked.folder / kind).glob(f"*.{kind}"))]
    own = {_name(checked, path) for path in files}
    for path in files:
        yield from _check_file(checked, path, own)
    yield from _check_cmake(checked, files)
    if files:
        yield from _check_manifest(checked)


def _name(checked: CheckedPackage, path: Path) -> str:
    return f"{checked.name}/{path.parent.name}/{path.stem}"


def _check_file(checked: CheckedPackage, path: Path, own: set[str]) -> Iterator[Problem]:
    try:
        spec = parse(_name(checked, path), path.read_text(encoding="utf-8"), str(path))
    except InterfaceSyntaxError as error:
        yield Problem(path, error.line, error.reason)
        return
    except (OSError, UnicodeDecodeError) as error:
        yield Problem(path, 0, f"cannot be read: {error}")
        return
    for field in _fields(spec):
        if field.type.is_message and field.line:
            yield from _check_type(checked, path, field, own)


def _fields(spec: InterfaceSpec) -> Iterator[Field]:
    parts: tuple[MessageSpec, ...] = ()
    if isinstance(spec, MessageSpec):
        parts = (spec,)
    elif isinstance(spec, ServiceSpec):
        parts = (spec.request, spec.response)
    elif isinstance(spec, ActionSpec):
        parts = (spec.goal, spec.result, spec.feedback)
    for part in parts:
        yield from part.fields


def _check_type(
    checked: CheckedPackage, path: Path, field: Field, own: set[str]
) -> Iterator[Problem]:
    package = field.type.base.partition("/")[0]
    if package == checked.name:
        known = sorted(own)
    else:
        known = interface_names(package)
    if field.type.base not in known:
        hint = did_you_mean(field.type.base, known, before="; ")
        yield Problem(path, field.line, f"there is no type {field.type.base}{hint}")
    elif package != checked.name and checked.manifest and package not in checked.manifest.named():
        text = f"{field.type.base} is used: add <depend>{package}</depend> to {MANIFEST}"
        # This is only a warning, because colcon also builds a workspace without this declaration.
        yield Problem(path, field.line, text, is_error=False)


def _check_cmake(checked: CheckedPackage, files: list[Path]) -> Iterator[Problem]:
    path = checked.folder / "CMakeLists.txt"
    try:
        named = read_cmake(checked.folder).interfaces
    except SetupFileError:
        return  # the check of the installation reports it
    for name, line in named.items():
        if not os.path.isfile(checked.folder / name):  # noqa: PTH113 - any name is allowed
            yield Problem(
                path, line, f"rosidl_generate_interfaces names {name}, which does not exist"
            )
    for file in files:
        name = file.relative_to(checked.folder).as_posix()
        if path.is_file() and name not in named:
            text = f"rosidl_generate_interfaces lacks {name}: ROS 2 would not generate code from it"
            yield Problem(path, 0, text, is_error=False)


def _check_manifest(checked: CheckedPackage) -> Iterator[Problem]:
    path = checked.folder / MANIFEST
    if checked.build_type == "ament_python":
        text = "ROS 2 makes messages in ament_cmake packages only; zbot makes them in every package"
        yield Problem(path, 0, text, is_error=False)
    elif checked.manifest is not None and _GROUP not in checked.manifest.groups:
        yield Problem(path, 0, f"add <member_of_group>{_GROUP}</member_of_group> for the messages")
