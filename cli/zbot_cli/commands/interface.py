"""Verbs of `zbot interface`: list types and packages, show definitions, and add packages."""

from __future__ import annotations

import sys
from contextlib import nullcontext
from pathlib import Path
from typing import Annotated

import typer

from zbot.errors.suggestion import did_you_mean
from zbot.interfaces import (
    ActionSpec,
    InterfaceSpec,
    ServiceSpec,
    get_interface,
    get_spec,
    interface_names,
    packages,
)
from zbot.interfaces.location import core_packages
from zbot.interfaces.repositories import how_to_add, repository_of
from zbot_cli.domain.types import all_types, find_types, type_hint
from zbot_cli.errors import CommandError
from zbot_cli.output.definition import definition
from zbot_cli.output.exit_status import Status
from zbot_cli.output.listing import AsJson, new_app, print_json

app = new_app("Look at message, service and action types")

_KINDS = {"msg": "Messages", "srv": "Services", "action": "Actions"}
OnlyMessages = Annotated[bool, typer.Option("-m", "--only-msgs", help="Only messages")]
OnlyServices = Annotated[bool, typer.Option("-s", "--only-srvs", help="Only services")]
OnlyActions = Annotated[bool, typer.Option("-a", "--only-actions", help="Only actions")]


def package_error(package: str) -> CommandError:
    """Return the error that no package of that name has message, service or action types."""
    if repository_of(package):
        hint = how_to_add(package)
    else:
        hint = did_you_mean(package, packages()) or ("`zbot interface packages` lists all packages")
    return CommandError(f"Unknown package '{package}'", hint=hint)


def interface_error(name: str) -> CommandError:
    """Return the error that a package has no type of that name."""
    package, _, interface = name.partition("/")
    known = interface_names(package)
    hint = did_you_mean(name, known) or f"there are {', '.join(known)}"
    return CommandError(f"Interface '{interface}' not found in package '{package}'", hint=hint)


def _wanted(messages: bool, services: bool, actions: bool) -> list[str]:
    chosen = dict(zip(_KINDS, (messages, services, actions), strict=True))
    return [kind for kind, wanted in chosen.items() if wanted] or list(_KINDS)


def _names(package: str, kinds: list[str]) -> list[str]:
    return [name for name in interface_names(package) if name.split("/")[1] in kinds]


@app.command("list")
def list_interfaces(
    only_msgs: OnlyMessages = False,
    only_srvs: OnlyServices = False,
    only_actions: OnlyActions = False,
    as_json: AsJson = False,
) -> None:
    """List all types."""
    kinds = _wanted(only_msgs, only_srvs, only_actions)
    found = {
        kind: sorted(name for one in packages() for name in _names(one, [kind])) for kind in kinds
    }
    if as_json:
        print_json(found)
        return
    for kind, names in found.items():
        print(f"{_KINDS[kind]}:")
        for name in names:
            print(f"    {name}")


@app.command("package")
def package_interfaces(
    package_name: Annotated[str, typer.Argument(help="Name of the package, e.g. std_msgs")],
    only_msgs: OnlyMessages = False,
    only_srvs: OnlyServices = False,
    only_actions: OnlyActions = False,
    as_json: AsJson = False,
) -> None:
    """List the types of one package."""
    if package_name not in packages():
        raise package_error(package_name)
    names = _names(package_name, _wanted(only_msgs, only_srvs, only_actions))
    if as_json:
        print_json(names)
        return
    for name in names:
        print(name)


@app.command("packages")
def list_packages(
    only_msgs: OnlyMessages = False,
    only_srvs: OnlyServices = False,
    only_actions: OnlyActions = False,
    as_json: AsJson = False,
) -> None:
    """List the packages that have types."""
    kinds = _wanted(only_msgs, only_srvs, only_actions)
    found = sorted(package for package in packages() if _names(package, kinds))
    if as_json:
        print_json(found)
        return
    for package in found:
        print(package)


@app.command("show")
def show(
    type_name: Annotated[
        str,
        typer.Argument(
            metavar="TYPE", help="Type, e.g. geometry_msgs/msg/Twist, or - to read a pipe"
        ),
    ],
    all_comments: Annotated[
        bool, typer.Option("--all-comments", help="Show comments of nested types too")
    ] = False,
    no_comments: Annotated[
        bool, typer.Option("--no-comments", help="Leave out comments and blank lines")
    ] = False,
    as_json: AsJson = False,
) -> None:
    """Show the definition of a type."""
    if type_name == "-":
        if sys.stdin.isatty():
            raise typer.BadParameter("expected stdin pipe")
        type_name = sys.stdin.readline().strip()
    spec = _spec(type_name)
    if as_json:
        from zbot.interfaces import type_description  # noqa: PLC0415 - only JSON needs it

        print_json(type_description(spec.name))
        return
    for line in definition(spec, comments=not no_comments, nested_comments=all_comments):
        print(line)


def _spec(word: str) -> InterfaceSpec:
    found = find_types(word) if word else []
    if len(found) == 1:
        return get_spec(found[0])
    parts = word.split("/")
    if len(parts) != 3 or not all(parts):
        raise CommandError(
            f"Invalid name '{word}'. Expected three parts separated by '/'",
            hint=type_hint(word, found, all_types()) if word else "write std_msgs/msg/String",
        )
    if parts[0] not in packages():
        raise package_error(parts[0])
    raise interface_error(word)


@app.command("proto")
def proto(
    type_name: Annotated[
        str, typer.Argument(metavar="TYPE", help="Type, e.g. geometry_msgs/msg/Twist")
    ],
    no_quotes: Annotated[
        bool, typer.Option("--no-quotes", help="Leave out the quotes around the text")
    ] = False,
) -> None:
    """Print a type's default values as YAML."""
    from zbot.interfaces.plain_value import plain  # noqa: PLC0415 - needed only by this verb
    from zbot.interfaces.yaml_text import dump  # noqa: PLC0415 - as above

    spec = _spec(type_name)
    cls = get_interface(spec.name)
    part = (
        cls.Request
        if isinstance(spec, ServiceSpec)
        else cls.Goal
        if isinstance(spec, ActionSpec)
        else cls
    )
    text = dump(plain(part()))
    print(text if no_quotes else f'"{text}"')


@app.command("add")
def add(
    source: Annotated[
        str,
        typer.Argument(
            metavar="SOURCE",
            help="Folder or archive (zip, tar, wheel) with packages, or a name on PyPI",
        ),
    ],
) -> int:
    """Add a package's types for all projects.

    The definitions are copied, so SOURCE can be deleted afterwards. ROS 2's own packages such as
    std_msgs always come from zbot. Other packages come from the workspace, or else from the added
    packages, or else from zbot.
    """
    from zbot.interfaces import collection, user_definitions  # noqa: PLC0415 - only this verb reads archives
    from zbot_cli.packages import pypi  # noqa: PLC0415 - as above

    path = Path(source).expanduser()
    if not path.exists() and not pypi.is_name(source):
        raise CommandError(f"there is no folder or archive '{source}'")
    with nullcontext(path) if path.exists() else pypi.downloaded(source) as place:
        found = collection.collect(place)
    core = core_packages()
    new = [package for package in found if package.name not in core]
    for package in new:
        user_definitions.check(package)
    for package in new:
        user_definitions.store(package)
        count = len(package.texts)
        print(f"{package.name}: {count} type{'s' * (count != 1)} added")
    for name in sorted({one.name for one in found}.intersection(core)):
        print(f"warning: {name} is not added: it is part of ROS 2 and of zbot", file=sys.stderr)
    missing = sorted({name for package in new for name in user_definitions.check(package)})
    for name in missing:
        print(f"warning: the types use {name}: {how_to_add(name)}", file=sys.stderr)
    return Status.OK if new and not missing else Status.ERROR


@app.command("remove")
def remove(
    package_name: Annotated[str, typer.Argument(help="Name of a package that was added")],
) -> None:
    """Remove a package that was added."""
    from zbot.interfaces import user_definitions  # noqa: PLC0415 - only this verb and `add` use the store

    user_definitions.remove(package_name)
    print(f"{package_name}: removed")
