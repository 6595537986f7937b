"""Verbs of `zbot interface`: list types, show definitions, convert them to C, add packages."""

from __future__ import annotations

import sys
from contextlib import nullcontext
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Final

import typer

from zbot.errors.suggestion import correction, did_you_mean
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
from zbot.interfaces.missing_import import how_to_add, repository_of
from zbot.interfaces.parser import split_comment
from zbot_cli.commands.interface.header import DEFAULT_HEADER, HeaderOptions, source
from zbot_cli.domain.types import all_types, find_types, type_hint
from zbot_cli.errors import CommandError
from zbot_cli.input.option_groups import with_option_groups
from zbot_cli.output.exit_status import Status
from zbot_cli.output.listing import AsJson, new_app, print_json, print_names

if TYPE_CHECKING:
    from collections.abc import Iterator

    from zbot.interfaces import Field

app = new_app("Look at message, service and action types")

_KINDS = {"msg": "Messages", "srv": "Services", "action": "Actions"}


@dataclass(frozen=True)
class WantedKinds:
    """Group of options that select kinds of types. Without an option, all kinds are selected."""

    only_msgs: Annotated[bool, typer.Option("-m", "--only-msgs", help="Only messages")] = False
    only_srvs: Annotated[bool, typer.Option("-s", "--only-srvs", help="Only services")] = False
    only_actions: Annotated[bool, typer.Option("-a", "--only-actions", help="Only actions")] = False

    @property
    def kinds(self) -> list[str]:
        """The selected kinds."""
        chosen = zip(_KINDS, (self.only_msgs, self.only_srvs, self.only_actions), strict=True)
        return [kind for kind, is_wanted in chosen if is_wanted] or list(_KINDS)


ALL_KINDS: Final = WantedKinds()


def package_error(package: str) -> CommandError:
    """Return the error that no package of that name has message, service or action types."""
    if repository_of(package):
        hint = how_to_add(package)
    else:
        hint = correction(package, packages()) or ("`zbot interface packages` lists all packages")
    return CommandError(f"Unknown package '{package}'", hint=hint)


def interface_error(name: str) -> CommandError:
    """Return the error that a package has no type of that name."""
    package, _, interface = name.partition("/")
    known = interface_names(package)
    hint = did_you_mean(name, known) or f"there are {', '.join(known)}"
    return CommandError(f"Interface '{interface}' not found in package '{package}'", hint=hint)


def _names(package: str, kinds: list[str]) -> list[str]:
    return [name for name in interface_names(package) if name.split("/")[1] in kinds]


@app.command("list")
@with_option_groups
def list_interfaces(
    wanted: WantedKinds = ALL_KINDS,
    as_json: AsJson = False,
) -> None:
    """List all types."""
    found = {
        kind: sorted(name for package in packages() for name in _names(package, [kind]))
        for kind in wanted.kinds
    }
    if as_json:
        print_json(found)
        return
    for kind, names in found.items():
        print(f"{_KINDS[kind]}:")
        for name in names:
            print(f"    {name}")


@app.command("package")
@with_option_groups
def package_interfaces(
    package_name: Annotated[str, typer.Argument(help="Name of the package, e.g. std_msgs")],
    wanted: WantedKinds = ALL_KINDS,
    as_json: AsJson = False,
) -> None:
    """List the types of one package."""
    if package_name not in packages():
        raise package_error(package_name)
    print_names(_names(package_name, wanted.kinds), count=False, as_json=as_json)


@app.command("packages")
@with_option_groups
def list_packages(
    wanted: WantedKinds = ALL_KINDS,
    as_json: AsJson = False,
) -> None:
    """List the packages that have types."""
    found = sorted(package for package in packages() if _names(package, wanted.kinds))
    print_names(found, count=False, as_json=as_json)


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
    for line in _definition_lines(spec, comments=not no_comments, nested_comments=all_comments):
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


@app.command("header")
@with_option_groups
def header(
    type_names: Annotated[
        list[str], typer.Argument(metavar="TYPE...", help="Types, e.g. sensor_msgs/msg/Temperature")
    ],
    output: Annotated[
        Path | None, typer.Option("-o", "--output", help="File to write; default: the terminal")
    ] = None,
    options: HeaderOptions = DEFAULT_HEADER,
) -> None:
    """Print source code of types for a microcontroller.

    The code has a struct or a class for each type, and converts it to and from the bytes of ROS 2.
    """
    text = source([_spec(name) for name in type_names], options)
    if output is None:
        print(text)
    else:
        output.write_text(f"{text}\n", encoding="utf-8", newline="\n")


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
    for name in sorted({package.name for package in found}.intersection(core)):
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


def _definition_lines(
    spec: InterfaceSpec, *, comments: bool = True, nested_comments: bool = False
) -> Iterator[str]:
    """Yield the lines of a definition. Each level of nested types is indented by one more TAB.

    Args:
        spec: The definition.
        comments: Keep the comments and blank lines of the definition itself.
        nested_comments: Keep the comments and blank lines of nested types, if `comments` is true.
    """
    yield from _lines(spec, "", comments=comments, nested_comments=comments and nested_comments)


def _lines(
    spec: InterfaceSpec, indent: str, *, comments: bool, nested_comments: bool
) -> Iterator[str]:
    nested = {field.line: field.type.base for field in _fields(spec) if field.type.is_message}
    for number, line in enumerate(spec.text.rstrip("\n").splitlines(), start=1):
        code, _ = split_comment(line)
        if comments or code:
            yield (indent + (line if comments else code)).rstrip()
        if number in nested:
            inner = get_spec(nested[number])
            yield from _lines(
                inner, f"{indent}\t", comments=nested_comments, nested_comments=nested_comments
            )


def _fields(spec: InterfaceSpec) -> tuple[Field, ...]:
    if isinstance(spec, ServiceSpec):
        return spec.request.fields + spec.response.fields
    if isinstance(spec, ActionSpec):
        return spec.goal.fields + spec.result.fields + spec.feedback.fields
    return spec.fields
