"""Keys and C lines of a plain zenoh-pico program that speaks zbot's own dialect."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from zbot.interfaces import get_interface, type_hash
from zbot.names import expand_topic_name, split_fully_qualified, validate_full_topic_name
from zbot.qos import QoSProfile
from zbot.wire.messagepack.codec import messagepack_codec_for
from zbot.wire.tokens import EndpointToken, EntityKind, NodeToken

if TYPE_CHECKING:
    from zbot.wire.dialect import Dialect

#: Text that stands for the id of the board's session, which the board knows only at run time.
ZID = "ZID"
_DEPTH = 10
_NID, _EID = 0, 1


@dataclass(frozen=True)
class ZenohKeys:
    """Keys of one endpoint and of its node. `ZID` is in the place of the session's id."""

    kind: EntityKind
    type_name: str
    data: str  #: key of the messages, or of a service's requests
    node_token: str
    endpoint_token: str


def zenoh_keys(
    name: str, type_name: str, *, kind: EntityKind, node: str, domain: int, dialect: Dialect
) -> ZenohKeys:
    """Return the keys of a topic or a service.

    Args:
        name: The topic or the service. A relative name gets the namespace of the node.
        type_name: Full name of the type, e.g. `std_msgs/msg/Float32`.
        kind: Kind of the endpoint.
        node: Name of the node, with a namespace if it has one: `/robot1/board`.
        domain: 0 to 232.
        dialect: zbot's own dialect, or that of a class.

    Raises:
        InvalidTopicNameError: The name breaks ROS 2's rules.
        InvalidNodeNameError: The name of the node breaks ROS 2's rules.
        InvalidNamespaceError: The namespace of the node breaks ROS 2's rules.
    """
    namespace, base = split_fully_qualified(node)
    full = expand_topic_name(name, base, namespace)
    validate_full_topic_name(full)
    node_token = NodeToken(domain=domain, zid=ZID, nid=_NID, namespace=namespace, node=base)
    token = EndpointToken(
        domain=dialect.domain_of(domain, full),
        zid=ZID,
        nid=_NID,
        eid=_EID,
        kind=kind,
        namespace=namespace,
        node=base,
        name=full,
        type_name=type_name,
        type_hash=type_hash(type_name),
        qos=QoSProfile(depth=_DEPTH),
    )
    return ZenohKeys(kind, type_name, dialect.data_key(token), node_token.key, token.key)


def key_lines(keys: ZenohKeys) -> str:
    """Return a table of the keys."""
    return (
        f"data:  {keys.data}\n"
        f"node:  {keys.node_token}\n"
        f"token: {keys.endpoint_token}\n"
        f"{ZID} is the id of the board's session, as Zenoh prints it: the C lines make it."
    )


def c_lines(keys: ZenohKeys) -> str:
    """Return C lines for zenoh-pico 1.5 and later that declare an endpoint and its two tokens."""
    return _C_LINES.format(
        data=keys.data,
        node=_format(keys.node_token),
        token=_format(keys.endpoint_token),
        example=_example(keys),
        globals=_GLOBALS[keys.kind],
        declare=_DECLARE[keys.kind],
    )


def _format(token: str) -> str:
    """Return the text of a token as a format of `snprintf`."""
    return token.replace("%", "%%").replace(f"/{ZID}/", "/%s/", 1)


def _example(keys: ZenohKeys) -> str:
    """Return the bytes of a message with default values."""
    if keys.kind is EntityKind.CLIENT:
        part = f"{keys.type_name}_Request"
    elif keys.kind is EntityKind.SERVICE:
        part = f"{keys.type_name}_Response"
    else:
        part = keys.type_name
    cls = get_interface(part)
    data = messagepack_codec_for(cls).encode(cls())
    rows = [data[at : at + 16] for at in range(0, len(data), 16)]
    lines = ["    " + " ".join(f"0x{byte:02x}," for byte in row) for row in rows]
    return f"/* {part} with default values, as a MessagePack map */\n" + (
        "static const uint8_t example[] = {\n" + "\n".join(lines) + "\n};"
    )


_GLOBALS = {
    EntityKind.PUBLISHER: "static z_owned_publisher_t publisher;",
    EntityKind.SUBSCRIPTION: (
        "static z_owned_subscriber_t subscriber;\n\n"
        "/* The payload of the sample is a MessagePack map. */\n"
        "static void on_message(z_loaned_sample_t *sample, void *context);"
    ),
    EntityKind.SERVICE: (
        "static z_owned_queryable_t server;\n\n"
        "/* The payload of the query is a MessagePack map. Reply with z_query_reply. */\n"
        "static void on_request(z_loaned_query_t *query, void *context);"
    ),
    EntityKind.CLIENT: (
        "/* To call the server, use z_get with DATA_KEY and the request as its payload. */"
    ),
}
_DECLARE = {
    EntityKind.PUBLISHER: """
    z_view_keyexpr_t keyexpr;
    z_view_keyexpr_from_str(&keyexpr, DATA_KEY);
    return z_declare_publisher(session, &publisher, z_view_keyexpr_loan(&keyexpr), NULL);""",
    EntityKind.SUBSCRIPTION: """
    z_view_keyexpr_t keyexpr;
    z_owned_closure_sample_t closure;
    z_closure_sample(&closure, on_message, NULL, NULL);
    z_view_keyexpr_from_str(&keyexpr, DATA_KEY);
    return z_declare_subscriber(session, &subscriber, z_view_keyexpr_loan(&keyexpr),
                                z_closure_sample_move(&closure), NULL);""",
    EntityKind.SERVICE: """
    z_view_keyexpr_t keyexpr;
    z_queryable_options_t options;
    z_owned_closure_query_t closure;
    z_queryable_options_default(&options);
    options.complete = true;
    z_closure_query(&closure, on_request, NULL, NULL);
    z_view_keyexpr_from_str(&keyexpr, DATA_KEY);
    return z_declare_queryable(session, &server, z_view_keyexpr_loan(&keyexpr),
                               z_closure_query_move(&closure), &options);""",
    EntityKind.CLIENT: ("\n    return Z_OK;"),
}
_C_LINES = """\
#include <stdio.h>
#include <zenoh-pico.h>

#define DATA_KEY "{data}"
#define NODE_TOKEN "{node}"
#define TOKEN "{token}"

{example}

static z_owned_liveliness_token_t node_token, token;
{globals}

static z_result_t declare_token(const z_loaned_session_t *session, z_owned_liveliness_token_t *to,
                                const char *format)
{{
    char zid[33] = "", key[512];
    z_id_t id = z_info_zid(session);
    z_view_keyexpr_t keyexpr;
    int length = 0;
    for (int i = 15; i >= 0; i--) {{ /* the id as Zenoh prints it, without leading zeros */
        if (length > 0 || id.id[i] != 0) {{
            length += snprintf(zid + length, 3, length > 0 ? "%02x" : "%x", id.id[i]);
        }}
    }}
    snprintf(key, sizeof key, format, zid);
    z_view_keyexpr_from_str(&keyexpr, key);
    return z_liveliness_declare_token(session, to, z_view_keyexpr_loan(&keyexpr), NULL);
}}

/* Call this after z_open, and again after each new z_open. */
static z_result_t declare_all(const z_loaned_session_t *session)
{{
    z_result_t result = declare_token(session, &node_token, NODE_TOKEN);
    if (result == Z_OK) {{
        result = declare_token(session, &token, TOKEN);
    }}
    if (result != Z_OK) {{
        return result;
    }}{declare}
}}"""
