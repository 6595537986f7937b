"""C header with the messages of some interfaces. It needs no other file and no heap."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from zbot.interfaces.spec import MessageSpec
from zbot.wire.embedded.c_literal import type_name
from zbot.wire.embedded.c_message import CMessage, type_macros
from zbot.wire.embedded.included_types import interfaces_of, messages_of

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

_TITLE = """\
/* Messages of ROS 2 for microcontrollers, in C99. This file was written by the command

       zbot interface header {names} --c

   A message of the type pkg/msg/Name has the struct pkg__msg__Name and these functions:

       pkg__msg__Name__init(&message);                                sets the default values
       status = pkg__msg__Name__write(&message, data, size, &length); message to bytes
       status = pkg__msg__Name__read(&message, data, length);         bytes to message

   ZBOT_CDR_OK is 0, and all errors are negative. Texts and sequences have memory for a fixed
   number of items. Define other numbers before you include this file:

       #define ZBOT_CDR_CAPACITY 32                                   of all sequences
       #define pkg__msg__Name__field__CAPACITY 360                    of one sequence

   pkg__msg__Name__MAX_SIZE is the number of bytes that __write needs at most. */
"""


def c_header(names: Iterable[str]) -> str:
    """Return the text of a C99 header for messages, services and actions.

    The header also contains the messages inside them. Two headers with the same message can be
    included in one program.

    Args:
        names: Full names, e.g. `std_msgs/msg/String` or `std_srvs/srv/SetBool`.

    Raises:
        UnknownPackageError: A package does not exist here.
        UnknownInterfaceError: A package has no such interface.
        InterfaceSyntaxError: A definition is wrong.
    """
    interfaces = interfaces_of(names)
    runtime = Path(__file__).with_name("cdr.h").read_text(encoding="utf-8")
    lines = [_TITLE.format(names=" ".join(spec.name for spec in interfaces)), runtime]
    for spec in interfaces:
        if not isinstance(spec, MessageSpec):
            lines += _guarded(spec.name)
    lines += _messages(messages_of(interfaces))
    return "\n".join(lines)


def _messages(specs: Iterable[MessageSpec]) -> Iterator[str]:
    with_defaults: frozenset[str] = frozenset()
    for spec in specs:
        message = CMessage(spec, with_defaults)
        if message.has_defaults:
            with_defaults |= {spec.name}
        yield from message.lines


def _guarded(name: str) -> list[str]:
    """Return the lines that define the names of a service or an action."""
    return [f"#ifndef {type_name(name)}__TYPE_NAME", *type_macros(name), "#endif", ""]
