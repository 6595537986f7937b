"""Request to a node for its definitions of a type, and the check of its answer."""

from __future__ import annotations

import os
import time
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from zbot.interfaces import get_interface
from zbot.interfaces.definition_limits import check_limits
from zbot.interfaces.errors import (
    DefinitionLimitError,
    InterfaceSyntaxError,
    UnknownInterfaceError,
    UnknownPackageError,
)
from zbot.interfaces.remote_definition import hash_among, specs_from, specs_from_sources
from zbot.node.service_types import DESCRIPTION_SERVICE
from zbot.transport import admin_query
from zbot.wire.attachment import GID_LENGTH, pack
from zbot.wire.errors import CodecError
from zbot.wire.tokens import EntityKind

if TYPE_CHECKING:
    from zbot.context import Context
    from zbot.interfaces import InterfaceSpec
    from zbot.wire.tokens import EndpointToken

ANSWER_TIMEOUT_S = 5.0  #: nodes usually answer within milliseconds, on bad Wi-Fi in 2 s


@dataclass(frozen=True)
class Provider:
    """A node that may know a type."""

    service: EndpointToken  #: its service `get_type_description`
    used: str = ""  #: type of the node's endpoint: the wanted type, or a part of it
    used_hash: str = ""


def definitions_of(context: Context, end: EndpointToken) -> list[InterfaceSpec]:
    """Ask a node for its definitions of an endpoint's type and of the types inside it.

    Returns:
        The definitions, which are not registered. The list is empty if the node does not send them.
    """
    services = context.graph.query().of_kind(EntityKind.SERVICE)
    for service in services:
        is_of_node = (service.zid, service.nid) == (end.zid, end.nid)
        if is_of_node and service.type_name == DESCRIPTION_SERVICE[0]:
            provider = Provider(service, end.type_name, end.type_hash)
            return request_definitions(context, provider, end.type_name)
    return []


def request_definitions(
    context: Context, provider: Provider, name: str, *, timeout_s: float = ANSWER_TIMEOUT_S
) -> list[InterfaceSpec]:
    """Ask a node for its definitions of a type and of the types inside it.

    Returns:
        The definitions, which are not registered. The list is empty if the node does not send
        them, or if they do not fit the hash of the type that the node uses.

    Raises:
        DefinitionLimitError: The definition would make messages that are too large.
    """
    answer = _ask(context, provider.service, name, timeout_s)
    return _checked(answer, name, provider) if answer else []


def _ask(context: Context, service: EndpointToken, name: str, timeout_s: float) -> Any:
    """Return a node's response, or `None` if there is none or the type is unknown."""
    srv_type: Any = get_interface(DESCRIPTION_SERVICE[0])
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


def _checked(answer: Any, name: str, provider: Provider) -> list[InterfaceSpec]:
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
                _individual(description) for description in described.referenced_type_descriptions
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
