"""Requests for the definitions of types that nodes use and that this machine does not have."""

from __future__ import annotations

import os
import time
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from zbot.interfaces import get_interface, get_spec, register_spec
from zbot.interfaces.definition_limits import check_limits
from zbot.interfaces.errors import (
    DefinitionLimitError,
    InterfaceSyntaxError,
    UnknownInterfaceError,
    UnknownPackageError,
)
from zbot.interfaces.registry import has_package
from zbot.interfaces.remote_definition import hash_among, specs_from, specs_from_sources
from zbot.node.type_description import SERVICE_TYPE
from zbot.transport import admin_query
from zbot.wire.attachment import GID_LENGTH, pack
from zbot.wire.errors import CodecError
from zbot.wire.tokens import EntityKind

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    from zbot.context import Context
    from zbot.graph.snapshot import Snapshot
    from zbot.interfaces import InterfaceSpec
    from zbot.wire.tokens import EndpointToken

#: The largest number of nodes to ask that do not use the wanted type, but another type of its
#: package. These nodes are asked last.
_MAX_OTHER_NODES = 8


@dataclass(frozen=True)
class _Provider:
    """A node that may know a type."""

    service: EndpointToken  #: its service `get_type_description`
    used: str = ""  #: type of the node's endpoint: the wanted type, or a part of it
    used_hash: str = ""


def learn_type(context: Context, name: str, *, timeout_s: float = 2.0) -> InterfaceSpec | None:
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
        InterfaceConflictError: A part of the type has another definition on this machine.
    """
    context.wait_for_peers()
    refusal: DefinitionLimitError | None = None
    for provider in _providers(context.graph.snapshot(), name):
        answer = _ask(context, provider.service, name, timeout_s)
        try:
            specs = answer and _checked(answer, name, provider)
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


def nodes_to_ask(context: Context, name: str) -> frozenset[str]:
    """Return the tokens of the nodes that `learn_type` would ask now."""
    return frozenset(one.service.key for one in _providers(context.graph.snapshot(), name))


def definitions_of(
    context: Context, end: EndpointToken, *, timeout_s: float = 2.0
) -> list[InterfaceSpec]:
    """Ask a node for its definitions of an endpoint's type and of the types inside it.

    Args:
        context: The context whose session sends the request.
        end: The endpoint.
        timeout_s: Seconds to wait for the node.

    Returns:
        The definitions, which are not registered. The list is empty if the node does not send them.
    """
    services = context.graph.query().of_kind(EntityKind.SERVICE)
    for service in services:
        is_of_node = (service.zid, service.nid) == (end.zid, end.nid)
        if is_of_node and service.type_name == SERVICE_TYPE[0]:
            provider = _Provider(service, end.type_name, end.type_hash)
            answer = _ask(context, service, end.type_name, timeout_s)
            return _checked(answer, end.type_name, provider) if answer else []
    return []


def _providers(graph: Snapshot, name: str) -> Iterator[_Provider]:
    services = {
        (end.zid, end.nid): end
        for end in graph.of_kind(EntityKind.SERVICE)
        if end.type_name == SERVICE_TYPE[0]
    }
    users = {
        (end.zid, end.nid): end
        for end in graph.endpoints
        if end.type_name == name or end.type_name.startswith(f"{name}_")
    }
    for node, end in users.items():
        if node in services:
            yield _Provider(services[node], end.type_name, end.type_hash)
    if has_package(name.partition("/")[0]):
        return  # the package is installed here without this type, so the name is wrong
    for node in list(_users_of_package(graph.endpoints, name))[:_MAX_OTHER_NODES]:
        if node in services and node not in users:
            yield _Provider(services[node])


def _users_of_package(endpoints: Iterable[EndpointToken], name: str) -> Iterator[tuple[str, int]]:
    """Yield the nodes that use other types of a type's package."""
    package = name.partition("/")[0] + "/"
    yield from dict.fromkeys(
        (end.zid, end.nid) for end in endpoints if end.type_name.startswith(package)
    )


def _ask(context: Context, service: EndpointToken, name: str, timeout_s: float) -> Any:
    """Return a node's response, or `None` if there is none or the type is unknown."""
    srv_type: Any = get_interface(SERVICE_TYPE[0])
    dialect = context.dialect
    replies = context.session.get(
        dialect.data_key(service),
        admin_query.large_queue(),
        payload=dialect.codec_for(srv_type.Request).encode(srv_type.Request(type_name=name)),
        attachment=pack(1, time.time_ns(), os.urandom(GID_LENGTH)),
        timeout=timeout_s,
    )
    decode = dialect.codec_for(srv_type.Response).decode
    for reply in replies:
        if reply.ok is not None:
            try:
                response: Any = decode(reply.ok.payload.to_bytes())
            except CodecError:
                continue  # a server of another type has this name
            if response.successful:
                return response
    return None


def _checked(answer: Any, name: str, provider: _Provider) -> list[InterfaceSpec]:
    """Return the response's definitions if they fit the node's type hash, else an empty list."""
    for read in (_from_texts, _from_description):
        try:
            specs = read(answer, name)
            check_limits(specs)
            if not provider.used or hash_among(provider.used, specs) == provider.used_hash:
                return specs
        except DefinitionLimitError:
            raise
        except (InterfaceSyntaxError, UnknownInterfaceError, UnknownPackageError):
            continue  # try the other form, or the next node
    return []


def _from_texts(answer: Any, name: str) -> list[InterfaceSpec]:
    texts = {
        source.type_name: source.raw_file_contents
        for source in answer.type_sources
        if source.encoding in {"msg", "srv", "action"}
    }
    return specs_from_sources(name, texts)


def _from_description(answer: Any, name: str) -> list[InterfaceSpec]:
    described = answer.type_description
    specs = specs_from(
        {
            "type_description": _individual(described.type_description),
            "referenced_type_descriptions": [
                _individual(one) for one in described.referenced_type_descriptions
            ],
        }
    )
    if specs[-1].name != name:
        raise InterfaceSyntaxError(name, 0, "", f"this describes {specs[-1].name}")
    return specs


def _individual(message: Any) -> dict[str, Any]:
    return {
        "type_name": message.type_name,
        "fields": [
            {
                "name": field.name,
                "type": {
                    "type_id": field.type.type_id,
                    "capacity": field.type.capacity,
                    "string_capacity": field.type.string_capacity,
                    "nested_type_name": field.type.nested_type_name,
                },
            }
            for field in message.fields
        ],
    }
