"""Types that the source code for a microcontroller includes, in the order that C needs."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.interfaces import get_spec, message_spec_of
from zbot.interfaces.registry import get_interface
from zbot.interfaces.spec import ActionSpec, InterfaceSpec, MessageSpec, ServiceSpec

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator


def interfaces_of(names: Iterable[str]) -> list[InterfaceSpec]:
    """Return the interfaces with these names, each once. An action's services follow the action.

    Raises:
        UnknownPackageError: A package does not exist here.
        UnknownInterfaceError: A package has no such interface.
        InterfaceSyntaxError: A definition is wrong.
    """
    found: dict[str, InterfaceSpec] = {}
    for name in names:
        spec = get_spec(name)
        parts = (spec.send_goal, spec.get_result) if isinstance(spec, ActionSpec) else ()
        found |= {one.name: one for one in (spec, *parts)}
    return list(found.values())


def messages_of(interfaces: Iterable[InterfaceSpec]) -> list[MessageSpec]:
    """Return the messages of interfaces and the messages inside them, each once, the inner first.

    The messages of service introspection (`_Event`) are left out.
    """
    found: dict[str, MessageSpec] = {}
    for interface in interfaces:
        for message in _own_messages(interface):
            _add(message, found)
    return list(found.values())


def _own_messages(spec: InterfaceSpec) -> Iterator[MessageSpec]:
    if isinstance(spec, ServiceSpec):
        yield from (spec.request, spec.response)
    elif isinstance(spec, ActionSpec):
        yield from (spec.goal, spec.result, spec.feedback, spec.feedback_message)
    else:
        yield spec


def _add(message: MessageSpec, found: dict[str, MessageSpec]) -> None:
    for kind in (field.type for field in message.fields):
        if kind.is_message and kind.base not in found:
            _add(message_spec_of(get_interface(kind.base)), found)
    found[message.name] = message
