"""Types that other nodes use. A definition that this machine lacks comes from one of the nodes."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.errors import ZbotError
from zbot.interfaces import get_interface, get_spec, register_spec
from zbot.interfaces.errors import DefinitionLimitError
from zbot.interfaces.registry import has_package, is_loaded
from zbot.node.definition_request import ANSWER_TIMEOUT_S, Provider, request_definitions
from zbot.node.service_types import DESCRIPTION_SERVICE
from zbot.wire.tokens import EntityKind

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    from zbot.context import Context
    from zbot.graph.snapshot import Snapshot, Token
    from zbot.interfaces import InterfaceSpec
    from zbot.wire.tokens import EndpointToken

#: The largest number of nodes to ask that do not use the wanted type, but another type of its
#: package. These nodes are asked last.
_MAX_OTHER_NODES = 8


class UnknownTypeError(ZbotError, LookupError):
    """No definition of a type is on this machine or in a node."""

    def __init__(self, type_name: str) -> None:
        self.type_name = type_name
        super().__init__(
            f"no definition of {type_name} was found: put its file into a package of your workspace"
        )


def interface(context: Context, name: str) -> type[Any]:
    """Return the class of a message, service or action type.

    If this machine has no definition, ask the nodes that use the type. This may take seconds.

    Args:
        context: The context whose session sends the requests.
        name: Full name of the type, e.g. `pkg/msg/Name`.

    Raises:
        UnknownTypeError: No definition of the type was found.
        DefinitionLimitError: The only definition would make messages that are too large.
        WrongValueError: A part of the type has another definition on this machine.
    """
    try:
        return get_interface(name)
    except LookupError:
        if learn_type(context, name) is None:
            raise UnknownTypeError(name) from None
        return get_interface(name)


def learn_type(
    context: Context, name: str, *, timeout_s: float = ANSWER_TIMEOUT_S
) -> InterfaceSpec | None:
    """Register a type that nodes of the domain use and that has no definition on this machine.

    Args:
        context: The context whose session sends the requests.
        name: Full name of the type, `pkg/msg/Name`. The type may also be a part of a used type.
        timeout_s: Seconds to wait for each node. Nodes usually answer within milliseconds.

    Returns:
        The definition, or `None` if no node has it. The definition has comments only if the node
        sent the text of the type's file.

    Raises:
        DefinitionLimitError: The only definition would make messages that are too large.
        WrongValueError: A part of the type has another definition on this machine.
    """
    context.wait_for_peers()
    refusal: DefinitionLimitError | None = None
    for provider in _providers(context.graph.snapshot(), name):
        try:
            specs = request_definitions(context, provider, name, timeout_s=timeout_s)
        except DefinitionLimitError as error:
            refusal = error  # another node may have a definition that zbot can use
            continue
        if specs:
            for spec in specs:
                register_spec(spec)
            return get_spec(name)
    if refusal is not None:
        raise refusal
    return None


class TypeSearch:
    """Search for types. It remembers which nodes were asked in vain, and asks them once only.

    A node that leaves and comes back is asked again, because it may have been suspended. Any thread
    may call the methods.

    Args:
        context: The context whose session sends the requests. Its graph is watched.
    """

    def __init__(self, context: Context) -> None:
        self._context = context
        self._found: set[str] = set()
        # For each type: whether a definition was here, the nodes that were asked, and the reason.
        self._failures: dict[str, tuple[bool, frozenset[str], ZbotError]] = {}
        context.graph.add_listener(self._on_change)

    def search(self, name: str) -> ZbotError | None:
        """Find the class of a type, as `interface` does. This may take seconds.

        Returns:
            Why the type cannot be used, or `None` if `get_interface` returns its class.
        """
        failure = self.failure(name)
        if failure is None and name not in self._found:
            sources = self._sources(name)
            try:
                interface(self._context, name)
            except ZbotError as error:
                if sources == self._sources(name):
                    self._failures[name] = *sources, error
                return error
            self._found.add(name)
        return failure

    def failure(self, name: str) -> ZbotError | None:
        """Return why the last `search` has failed. This asks no node.

        Returns:
            `None` if a new `search` may find the type: there are other nodes to ask now, or this
            machine has learned the type in another way.
        """
        known = self._failures.get(name)
        return known[-1] if known is not None and known[:-1] == self._sources(name) else None

    def _sources(self, name: str) -> tuple[bool, frozenset[str]]:
        """Return whether a definition is on this machine, and the nodes to ask for one."""
        providers = _providers(self._context.graph.snapshot(), name)
        return is_loaded(name), frozenset(provider.service.key for provider in providers)

    def _on_change(self, token: Token, appeared: bool) -> None:
        if not appeared:
            for name, (_, asked, _) in list(self._failures.items()):
                if token.key in asked:
                    self._failures.pop(name, None)


def _providers(graph: Snapshot, name: str) -> Iterator[Provider]:
    services = {
        (end.zid, end.nid): end
        for end in graph.of_kind(EntityKind.SERVICE)
        if end.type_name == DESCRIPTION_SERVICE[0]
    }
    users = {
        (end.zid, end.nid): end
        for end in graph.endpoints
        if end.type_name == name or end.type_name.startswith(f"{name}_")
    }
    for node, end in users.items():
        if node in services:
            yield Provider(services[node], end.type_name, end.type_hash)
    if has_package(name.partition("/")[0]):
        return  # the package is installed here without this type, so the name is wrong
    for node in list(_users_of_package(graph.endpoints, name))[:_MAX_OTHER_NODES]:
        if node in services and node not in users:
            yield Provider(services[node])


def _users_of_package(endpoints: Iterable[EndpointToken], name: str) -> Iterator[tuple[str, int]]:
    """Yield the nodes that use other types of a type's package."""
    package = name.partition("/")[0] + "/"
    yield from dict.fromkeys(
        (end.zid, end.nid) for end in endpoints if end.type_name.startswith(package)
    )
