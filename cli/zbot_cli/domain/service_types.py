"""Services and their types, as users name them and as the graph knows them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.errors import ZbotError
from zbot.names import nearest
from zbot.wire.tokens import EntityKind
from zbot_cli.domain.types import all_types, find_types, learn, type_hint

if TYPE_CHECKING:
    from zbot.graph.snapshot import NamesAndTypes, Snapshot

#: The types of what every node serves about itself; lists leave these services out, which would
#: bury those that a lesson is about.
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


class InvalidServiceTypeError(ZbotError):
    """A word names no service type."""

    def __init__(self, word: str, hint: str, *, is_known: bool = False) -> None:
        self.word, self.hint = word, hint
        what = "passed type is not a service" if is_known else "passed service type is invalid"
        super().__init__(f"The {what}")


class UnknownServiceError(ZbotError):
    """Nobody serves a service of that name, nor is a client of it."""

    def __init__(self, name: str, graph: Snapshot) -> None:
        self.name = name
        self.hint = suggestion(name, graph)
        super().__init__(f"Unknown service '{name}'")


class SeveralServiceTypesError(ZbotError):
    """A service has more than one type, and none was named."""

    def __init__(self, name: str, types: list[str]) -> None:
        self.name, self.types = name, types
        self.hint = f"name the one you mean: {types[0]}"
        super().__init__(f"Service '{name}' has more than one type: [{', '.join(types)}]")


class OtherServiceTypeError(ZbotError):
    """The servers of a service have another type than the one that was named."""

    def __init__(self, name: str, wanted: str, types: list[str]) -> None:
        self.name, self.wanted, self.types = name, wanted, types
        self.hint = "leave the type out: the graph knows it"
        super().__init__(f"Service '{name}' has the type {', '.join(types)}, not {wanted}")


def suggestion(name: str, graph: Snapshot) -> str | None:
    """Return a question that names the service which may have been meant."""
    guess = nearest(name, [known for known, _ in graph.services()])
    return f"did you mean {guess}?" if guess else None


def known_services(graph: Snapshot) -> NamesAndTypes:
    """Return every service that somebody serves or is a client of, with its types."""
    return graph.names_and_types(EntityKind.SERVICE, EntityKind.CLIENT)


def served_type(graph: Snapshot, name: str) -> str | None:
    """Return the type of a service, `None` if nobody serves it.

    Raises:
        SeveralServiceTypesError: It has several.
    """
    types = dict(graph.services()).get(name)
    if types is not None and len(types) > 1:
        raise SeveralServiceTypesError(name, types)
    return None if types is None else types[0]


def check_served(graph: Snapshot, name: str, type_name: str) -> None:
    """Check that nobody serves a service with another type only: a call would never succeed.

    Raises:
        OtherServiceTypeError: All servers have another type.
    """
    types = dict(graph.services()).get(name, [type_name])
    if type_name not in types:
        raise OtherServiceTypeError(name, type_name, types)


def resolve_service_type(word: str) -> str:
    """Return the full name of a service type.

    Raises:
        InvalidServiceTypeError: There is none of that name, or several of a short one.
    """
    found = find_types(word)
    services = list(filter(_is_service, found))
    if len(services) != 1:
        hint = type_hint(word, services, filter(_is_service, all_types()))
        raise InvalidServiceTypeError(word, hint, is_known=bool(found) and not services)
    return services[0]


def _is_service(name: str) -> bool:
    return "/srv/" in name


def service_class(type_name: str) -> type[Any]:
    """Return a service class; what this machine does not know, the nodes that use it tell.

    Raises:
        InvalidServiceTypeError: There is no definition of the type.
    """
    from zbot.interfaces import get_interface  # noqa: PLC0415 - lists do without

    try:
        return get_interface(type_name)
    except LookupError:
        if learn(type_name):
            return get_interface(type_name)
        hint = "put its .srv file into a package of your workspace"
        raise InvalidServiceTypeError(type_name, hint) from None
