"""Types that only another machine knows: they are asked of the nodes that use them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from zbot.interfaces import get_interface, get_spec, register_spec
from zbot.interfaces.errors import InterfaceSyntaxError, UnknownInterfaceError, UnknownPackageError
from zbot.interfaces.registry import has_package
from zbot.interfaces.remote_definition import hash_among, specs_from, specs_from_sources
from zbot.node.type_description import SERVICE_TYPE
from zbot.transport import admin_query
from zbot.wire.codec import CodecError
from zbot.wire.tokens import EntityKind

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    from zbot.context import Context
    from zbot.graph.snapshot import Snapshot
    from zbot.interfaces import InterfaceSpec
    from zbot.wire.tokens import EndpointToken

#: So many nodes are asked about a type that none of them is seen to use.
_MOST_GUESSES = 8


@dataclass(frozen=True)
class _Teller:
    """A node that may know a type."""

    service: str  #: full name of its service `get_type_description`
    used: str = ""  #: the type, or the part of it, that it is seen to use
    used_hash: str = ""


def learn_type(context: Context, name: str, *, timeout_s: float = 2.0) -> InterfaceSpec | None:
    """Make a type known that nodes of the domain use and that has no definition here.

    Args:
        context: A session.
        name: Full name of the type, `pkg/msg/Name`; also one that is only inside a used type.
        timeout_s: How long each node may take to answer; they usually take milliseconds.

    Returns:
        Its definition, with all comments if the node has its source; `None` if nobody tells.

    Raises:
        InterfaceConflictError: A type inside it has another definition here.
    """
    context.meet()
    for teller in _tellers(context.graph.snapshot(), name):
        answer = _ask(context, teller.service, name, timeout_s)
        specs = answer and _checked(answer, name, teller)
        if specs:
            for spec in specs:
                register_spec(spec)
            return get_spec(name)
    return None


def _tellers(graph: Snapshot, name: str) -> Iterator[_Teller]:
    services = {
        (end.zid, end.nid): end.name
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
            yield _Teller(services[node], end.type_name, end.type_hash)
    if has_package(name.partition("/")[0]):
        return  # it would be known here: the name is wrong
    for node in list(_neighbours(graph.endpoints, name))[:_MOST_GUESSES]:
        if node in services and node not in users:
            yield _Teller(services[node])


def _neighbours(endpoints: Iterable[EndpointToken], name: str) -> Iterator[tuple[str, int]]:
    """Yield the nodes that use other types of a type's package."""
    package = name.partition("/")[0] + "/"
    yield from dict.fromkeys(
        (end.zid, end.nid) for end in endpoints if end.type_name.startswith(package)
    )


def _ask(context: Context, service: str, name: str, timeout_s: float) -> Any:
    """Return what a node answers; `None` if it does not know the type, or gives no answer."""
    srv_type: Any = get_interface(SERVICE_TYPE[0])
    dialect = context.dialect
    replies = context.session.get(
        dialect.topic_key(context.get_domain_id(), service),
        admin_query.room(),
        payload=dialect.codec_for(srv_type.Request).encode(srv_type.Request(type_name=name)),
        timeout=timeout_s,
    )
    decode = dialect.codec_for(srv_type.Response).decode
    for reply in replies:
        if reply.ok is not None:
            try:
                response: Any = decode(reply.ok.payload.to_bytes())
            except CodecError:
                continue  # a server of something else under this name
            if response.successful:
                return response
    return None


def _checked(answer: Any, name: str, teller: _Teller) -> list[InterfaceSpec]:
    """Return the definitions in an answer, from texts if these are what the node uses."""
    for read in (_from_texts, _from_description):
        try:
            specs = read(answer, name)
            if not teller.used or hash_among(teller.used, specs) == teller.used_hash:
                return specs
        except (InterfaceSyntaxError, UnknownInterfaceError, UnknownPackageError):
            continue  # the other form may do; a node that sends nonsense tells nothing
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
