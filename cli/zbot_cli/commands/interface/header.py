"""Source code for microcontrollers that `zbot interface header` prints."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Final

import typer

from zbot.wire.tokens import EntityKind
from zbot_cli.errors import CommandError

if TYPE_CHECKING:
    from collections.abc import Sequence

    from zbot.interfaces import InterfaceSpec

_KINDS = {
    "publisher": EntityKind.PUBLISHER,
    "subscription": EntityKind.SUBSCRIPTION,
    "service": EntityKind.SERVICE,
    "client": EntityKind.CLIENT,
}


@dataclass(frozen=True)
class HeaderOptions:
    """Group of options that choose the language, or the keys of one topic."""

    in_c: Annotated[bool, typer.Option("--c", help="C99 header; the default")] = False
    micropython: Annotated[bool, typer.Option("--micropython", help="Module for MicroPython")] = (
        False
    )
    token: Annotated[
        str,
        typer.Option(
            "--token",
            metavar="NAME",
            help="Keys and C lines with which a plain Zenoh program has this topic or service",
        ),
    ] = ""
    node: Annotated[str, typer.Option("--node", help="With --token: name of the board")] = "board"
    kind: Annotated[
        str,
        typer.Option(
            "--kind",
            help="With --token: publisher, subscription, service or client; "
            "default: publisher or service",
        ),
    ] = ""


DEFAULT_HEADER: Final = HeaderOptions()


def source(specs: Sequence[InterfaceSpec], options: HeaderOptions) -> str:
    """Return the source code for microcontrollers.

    Raises:
        CommandError: The options do not fit together, or do not fit the types.
    """
    if options.in_c + options.micropython + bool(options.token) > 1:
        raise CommandError("choose one of --c, --micropython and --token")
    names = [spec.name for spec in specs]
    if options.token:
        return _keys(names, options)
    if options.micropython:
        from zbot.wire.embedded.micropython_module import micropython_module  # noqa: PLC0415 - see below

        return micropython_module(names)
    from zbot.wire.embedded.c_header import c_header  # noqa: PLC0415 - one of three is needed

    return c_header(names)


def _keys(names: Sequence[str], options: HeaderOptions) -> str:
    from zbot.transport import config, membership  # noqa: PLC0415 - only this option needs it
    from zbot.wire.dialect import CLASSROOM, NATIVE  # noqa: PLC0415 - as above
    from zbot.wire.embedded.zenoh_keys import c_lines, key_lines, zenoh_keys  # noqa: PLC0415 - see above

    if len(names) != 1:
        raise CommandError("--token needs one type")
    joined = membership.load()
    keys = zenoh_keys(
        options.token,
        names[0],
        kind=_kind(names[0], options.kind),
        node=options.node,
        domain=config.domain_id(),
        dialect=CLASSROOM if joined is not None and joined.in_class else NATIVE,
    )
    comment = key_lines(keys).replace("\n", "\n   ")
    return f"/* {comment} */\n{c_lines(keys)}"


def _kind(type_name: str, word: str) -> EntityKind:
    is_service = type_name.split("/")[1] == "srv"
    if type_name.split("/")[1] == "action":
        raise CommandError(
            "--token does not support actions: an action has five services and topics"
        )
    kind = word or ("service" if is_service else "publisher")
    if kind not in _KINDS:
        raise CommandError(f"Unknown kind '{kind}'", hint=f"choose one of {', '.join(_KINDS)}")
    if (_KINDS[kind] in {EntityKind.SERVICE, EntityKind.CLIENT}) != is_service:
        hint = "a service type has a service or a client, a message a publisher or a subscription"
        raise CommandError(f"{type_name} has no {kind}", hint=hint)
    return _KINDS[kind]
