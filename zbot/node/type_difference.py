"""Sentences about two endpoints that cannot hear each other, because their types differ.

With the keys of ROS 2's rmw_zenoh, the hash of a type's definition is a part of each key. So
endpoints with different definitions of one type get no messages from each other. Zenoh reports no
error.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.interfaces import type_description
from zbot.interfaces.difference import difference
from zbot.interfaces.errors import (
    InterfaceSyntaxError,
    UnknownInterfaceError,
    UnknownPackageError,
)
from zbot.interfaces.remote_definition import specs_from
from zbot.node.definition_request import definitions_of

if TYPE_CHECKING:
    from zbot.context import Context
    from zbot.wire.tokens import EndpointToken

_HASH_LENGTH = 16  # characters of a hash that a sentence shows


def difference_text(context: Context, mine: EndpointToken, other: EndpointToken) -> str:
    """Return a sentence about the definitions of two endpoints that cannot hear each other.

    This function asks the other node for its definition. This takes milliseconds, or 5 s if the
    other node does not answer.
    """
    who = other.full_node_name
    if not (_has_hash(mine) and _has_hash(other)):
        with_hash, without = (who, "this program") if _has_hash(other) else ("this program", who)
        return (
            f"{mine.name}: {without} speaks as ROS 2 Humble, and {with_hash} as a later ROS 2: "
            "they cannot hear each other; if all nodes are of one ROS 2, start this program again"
        )
    details = _details(context, mine, other)
    return (
        f"{mine.name}: {who} has another definition of {mine.type_name}, so ROS 2 delivers nothing "
        f"between it and this node: {details}; use the same definition in both"
    )


def _has_hash(token: EndpointToken) -> bool:
    return token.type_hash.startswith("RIHS")


def _details(context: Context, mine: EndpointToken, other: EndpointToken) -> str:
    short = [token.type_hash[:_HASH_LENGTH] for token in (mine, other)]
    hashes = f"its hash is {short[0]}... here and {short[1]}... there"
    try:
        here = specs_from(type_description(mine.type_name))
    except (InterfaceSyntaxError, UnknownInterfaceError, UnknownPackageError):
        return hashes
    return difference(here, definitions_of(context, other)) or hashes
