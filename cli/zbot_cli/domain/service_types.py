"""Services and their types, from words of the command line or from the graph."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.errors.suggestion import did_you_mean
from zbot.wire.tokens import EntityKind
from zbot_cli.domain.types import all_types, find_types, learn, type_hint
from zbot_cli.errors import CommandError

if TYPE_CHECKING:
    from zbot.graph.snapshot import NamesAndTypes, Snapshot

#: Types of the services that every node has. Lists leave these services out, so that the services
#: of the user's own programs are easy to find.
NODE_SERVICE_TYPES = frozenset(
    {
        "rcl_interfaces/srv/DescribeParameters",
        "rcl_interfaces/srv/GetParameterTypes",
        "rcl_interfaces/srv/GetParameters",
        "rcl_interfaces/srv/ListParameters",
        "rcl_interfaces/srv/SetParameters",
        "rcl_interfaces/srv/SetParametersAtomically",
        "type_description_interfaces/srv/GetTypeDescription",
    }
)


def invalid_service_type_error(hint: str, *, is_known: bool = False) -> CommandError:
    """Return the error that a word is not the name of a service type."""
    what = "passed type is not a service" if is_known else "passed service type is invalid"
    return CommandError(f"The {what}", hint=hint)


def unknown_service_error(name: str, graph: Snapshot) -> CommandError:
    """Return the error that no service of that name has a server or a client."""
    hint = suggestion(name, graph)
    return CommandError(f"Unknown service '{name}'", hint=hint)


def several_service_types_error(name: str, types: list[str]) -> CommandError:
    """Return the error that a service has several types, and the command line gives none."""
    hint = f"add the type that you mean, e.g. {types[0]}"
    return CommandError(f"Service '{name}' has more than one type: [{', '.join(types)}]", hint=hint)


def suggestion(name: str, graph: Snapshot, before: str = "") -> str:
    """Return a question with the most similar service name, or an empty string."""
    return did_you_mean(name, [known for known, _ in graph.services()], before=before)


def known_services(graph: Snapshot) -> NamesAndTypes:
    """Return all services that have a server or a client, with their types."""
    return graph.names_and_types(EntityKind.SERVICE, EntityKind.CLIENT)


def served_type(graph: Snapshot, name: str) -> str | None:
    """Return the type of a service, or `None` if it has no server.

    Raises:
        CommandError: The service has more than one type.
    """
    types = dict(graph.services()).get(name)
    if types is not None and len(types) > 1:
        raise several_service_types_error(name, types)
    return None if types is None else types[0]


def check_served(graph: Snapshot, name: str, type_name: str) -> None:
    """Check that a service has a server of this type, or has no server at all.

    Raises:
        CommandError: All servers have another type.
    """
    types = dict(graph.services()).get(name, [type_name])
    if type_name not in types:
        raise CommandError(
            f"Service '{name}' has the type {', '.join(types)}, not {type_name}",
            hint="leave the type out, and it is taken from the server",
        )


def resolve_service_type(word: str) -> str:
    """Return the full name of a service type.

    Raises:
        CommandError: No type has this name, or several types have this short name.
    """
    found = find_types(word)
    services = list(filter(_is_service, found))
    if len(services) != 1:
        hint = type_hint(word, services, filter(_is_service, all_types()))
        raise invalid_service_type_error(hint, is_known=bool(found) and not services)
    return services[0]


def _is_service(name: str) -> bool:
    return "/srv/" in name


def service_class(type_name: str) -> type[Any]:
    """Return a service class. If this machine lacks the definition, ask the nodes for it.

    Raises:
        CommandError: No definition of the type is on this machine or in a node.
    """
    from zbot.interfaces import get_interface  # noqa: PLC0415 - not needed by `list`

    try:
        return get_interface(type_name)
    except LookupError:
        if learn(type_name):
            return get_interface(type_name)
        hint = "put its .srv file into a package of your workspace"
        raise invalid_service_type_error(hint) from None
