"""`zbot interface`: which types there are, and what is in them."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Annotated

import typer

from zbot.errors import ZbotError
from zbot.interfaces import (
    ActionSpec,
    MessageSpec,
    ServiceSpec,
    get_interface,
    get_spec,
    interface_names,
    packages,
)
from zbot.names import nearest
from zbot_cli.listing import AsJson, new_app, print_json

if TYPE_CHECKING:
    from collections.abc import Iterator

app = new_app("Look at message, service and action types")

_KINDS = {"msg": "Messages", "srv": "Services", "action": "Actions"}
OnlyMessages = Annotated[bool, typer.Option("-m", "--only-msgs", help="Only messages")]
OnlyServices = Annotated[bool, typer.Option("-s", "--only-srvs", help="Only services")]
OnlyActions = Annotated[bool, typer.Option("-a", "--only-actions", help="Only actions")]


class InterfaceNameError(ZbotError):
    """A type is not named in three parts."""

    def __init__(self, name: str) -> None:
        self.hint = "write it like std_msgs/msg/String"
        super().__init__(f"Invalid name '{name}'. Expected three parts separated by '/'")


class PackageError(ZbotError):
    """No package of that name has interfaces."""

    def __init__(self, package: str) -> None:
        guess = nearest(package, packages())
        self.hint = f"did you mean {guess}?" if guess else "zbot interface packages lists them"
        super().__init__(f"Unknown package '{package}'")


class InterfaceError(ZbotError):
    """A package has no such interface."""

    def __init__(self, name: str) -> None:
        known = interface_names(name.split("/", maxsplit=1)[0])
        guess = nearest(name, known)
        self.hint = f"did you mean {guess}?" if guess else f"there are {', '.join(known)}"
        super().__init__(f"Unknown interface '{name}'")


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
        raise PackageError(package_name)
    names = _names(package_name, _wanted(only_msgs, only_srvs, only_actions))
    if as_json:
        print_json(names)
    else:
        print("\n".join(names))


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
    else:
        print("\n".join(found))


@app.command("show")
def show(
    type_name: Annotated[
        str,
        typer.Argument(metavar="TYPE", help="e.g. geometry_msgs/msg/Twist; - reads it from a pipe"),
    ],
    all_comments: Annotated[
        bool, typer.Option("--all-comments", help="Comments of nested types too")
    ] = False,
    no_comments: Annotated[
        bool, typer.Option("--no-comments", help="No comments and blank lines")
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

        print_json(type_description(type_name))
        return
    lines = _definition(
        spec.text, spec.name, nested_comments=all_comments, comments=not no_comments
    )
    print("\n".join(lines))


def _spec(name: str) -> MessageSpec | ServiceSpec | ActionSpec:
    parts = name.split("/")
    if len(parts) != 3 or not all(parts):
        raise InterfaceNameError(name)
    if parts[0] not in packages():
        raise PackageError(parts[0])
    if name not in interface_names(parts[0]):
        raise InterfaceError(name)
    return get_spec(name)


def _definition(
    text: str, owner: str, *, nested_comments: bool, comments: bool, indent: str = ""
) -> Iterator[str]:
    """Yield a definition's lines, each nested type's own lines below its field."""
    package = owner.split("/", maxsplit=1)[0]
    keep = comments and (not indent or nested_comments)
    for line in text.rstrip("\n").splitlines():
        code, _comment = _split(line)
        if not code and not keep:
            continue
        yield (indent + (line if keep else code)).rstrip()
        nested = _nested_name(code, package)
        if nested is not None:
            yield from _definition(
                get_spec(nested).text,
                nested,
                nested_comments=nested_comments,
                comments=comments,
                indent=indent + "\t",
            )


def _split(line: str) -> tuple[str, str]:
    """Tell a line's code from its comment; a `#` inside quotes is no comment."""
    quote = ""
    for index, character in enumerate(line):
        if quote:
            quote = "" if character == quote else quote
        elif character in "\"'":
            quote = character
        elif character == "#":
            return line[:index].rstrip(), line[index:]
    return line.rstrip(), ""


def _nested_name(code: str, package: str) -> str | None:
    words = code.split()
    if len(words) < 2 or "=" in code.split("[", maxsplit=1)[0]:
        return None
    base = words[0].split("[")[0].split("<")[0]
    if base == "Header":
        return "std_msgs/msg/Header"
    if "/" in base:
        parts = base.split("/")
        return f"{parts[0]}/msg/{parts[-1]}"
    return f"{package}/msg/{base}" if base[:1].isupper() else None


@app.command("proto")
def proto(
    type_name: Annotated[str, typer.Argument(metavar="TYPE", help="e.g. geometry_msgs/msg/Twist")],
    no_quotes: Annotated[
        bool, typer.Option("--no-quotes", help="Leave out the quotes around")
    ] = False,
) -> None:
    """Print a type's values as YAML, to copy and change."""
    from zbot_cli.message_text import Form, plain  # noqa: PLC0415 - only this verb shows values
    from zbot_cli.yaml_text import dump  # noqa: PLC0415 - as above

    spec = _spec(type_name)
    cls = get_interface(spec.name)
    part = (
        cls.Request
        if isinstance(spec, ServiceSpec)
        else cls.Goal
        if isinstance(spec, ActionSpec)
        else cls
    )
    text = dump(plain(part(), Form(length=None)))
    print(text if no_quotes else f'"{text}"')
