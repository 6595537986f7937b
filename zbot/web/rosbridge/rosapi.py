"""Services that describe the system to web programs. Their names begin with `/rosapi/`.

Only clients of rosbridge can call these services, because this module answers the calls without a
node. If a node of the domain serves a service with such a name, e.g. the node of ROS 2's package
rosapi, clients call the service of that node.
"""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any, TypeAlias

from zbot.bag.definition import definition_text
from zbot.errors import ZbotError
from zbot.graph.snapshot import full_names
from zbot.interfaces.plain_value import json_value
from zbot.interfaces.registry import interface_names, packages
from zbot.names import is_hidden
from zbot.parameters.parameter import Parameter
from zbot.remote.parameters import RemoteParameters, nodes_with_parameters
from zbot.remote.service_calls import ServiceCalls
from zbot.text.json_reader import JsonError, read_json
from zbot.web.rosbridge.client_message import RosbridgeError
from zbot.web.rosbridge.type_details import type_details
from zbot.wire.tokens import EntityKind

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.graph.snapshot import Snapshot
    from zbot.web.rosbridge.bridge import Bridge

    Procedure: TypeAlias = Callable[[Bridge, dict[str, Any]], dict[str, Any]]

_MAX_WORD = 1000
_PATIENCE_S = 5.0


def arguments(args: Any) -> dict[str, Any]:
    """Return the arguments of a call by name.

    Raises:
        RosbridgeError: The arguments are not a JSON object.
    """
    if args is None or args == []:
        return {}
    if not isinstance(args, dict):
        raise RosbridgeError("the field 'args' must be an object")
    return args


def _word(args: dict[str, Any], name: str, default: str | None = None) -> str:
    value = args.get(name, default)
    if not isinstance(value, str) or len(value) > _MAX_WORD:
        raise RosbridgeError(f"the argument {name!r} must be a string")
    return value


def _shown(names_and_types: list[tuple[str, list[str]]]) -> list[tuple[str, str]]:
    return [(name, types[0]) for name, types in names_and_types if not is_hidden(name)]


def _with_type(names_and_types: list[tuple[str, list[str]]], wanted: str) -> list[str]:
    return [
        name for name, type_name in _shown(names_and_types) if _short(type_name) == _short(wanted)
    ]


def _short(type_name: str) -> str:
    """Return `std_msgs/String` for `std_msgs/msg/String`. Web programs may use both forms."""
    return f"{type_name.partition('/')[0]}/{type_name.rpartition('/')[2]}"


def _topics(bridge: Bridge, _args: dict[str, Any]) -> dict[str, Any]:
    found = _shown(bridge.graph().topics())
    return {"topics": [name for name, _ in found], "types": [type_name for _, type_name in found]}


def _topics_for_type(bridge: Bridge, args: dict[str, Any]) -> dict[str, Any]:
    return {"topics": _with_type(bridge.graph().topics(), _word(args, "type"))}


def _topics_and_raw_types(bridge: Bridge, args: dict[str, Any]) -> dict[str, Any]:
    found = _topics(bridge, args)
    return {
        **found,
        "typedefs_full_text": [_full_text(bridge, type_name) for type_name in found["types"]],
    }


def _full_text(bridge: Bridge, type_name: str) -> str:
    try:
        bridge.interface("msg", type_name)  # another machine may have to send the definition
        return definition_text(type_name)
    except ZbotError as error:
        return f"# {error}"


def _services(bridge: Bridge, _args: dict[str, Any]) -> dict[str, Any]:
    return {"services": [name for name, _ in _shown(bridge.graph().services())]}


def _services_for_type(bridge: Bridge, args: dict[str, Any]) -> dict[str, Any]:
    return {"services": _with_type(bridge.graph().services(), _word(args, "type"))}


def _nodes(bridge: Bridge, _args: dict[str, Any]) -> dict[str, Any]:
    names = sorted(set(full_names(bridge.graph().nodes)))
    return {"nodes": [name for name in names if not is_hidden(name)]}


def _node_details(bridge: Bridge, args: dict[str, Any]) -> dict[str, Any]:
    node, graph = _node_name(_word(args, "node")), bridge.graph()

    def names(kind: EntityKind) -> list[str]:
        return [name for name, _ in _shown(graph.names_and_types(kind, node=node))]

    return {
        "subscribing": names(EntityKind.SUBSCRIPTION),
        "publishing": names(EntityKind.PUBLISHER),
        "services": names(EntityKind.SERVICE),
    }


def _node_name(name: str) -> str:
    return name if name.startswith("/") else f"/{name}"


def _action_servers(bridge: Bridge, _args: dict[str, Any]) -> dict[str, Any]:
    found = bridge.graph().actions(EntityKind.SERVICE)
    return {"action_servers": [name for name, _ in found]}


def _topic_type(bridge: Bridge, args: dict[str, Any]) -> dict[str, Any]:
    return {"type": _type_of(bridge.graph().topics(), _word(args, "topic"))}


def _service_type(bridge: Bridge, args: dict[str, Any]) -> dict[str, Any]:
    return {"type": _type_of(bridge.graph().services(), _word(args, "service"))}


def _action_type(bridge: Bridge, args: dict[str, Any]) -> dict[str, Any]:
    return {"type": _type_of(bridge.graph().actions(EntityKind.SERVICE), _word(args, "action"))}


def _type_of(names_and_types: list[tuple[str, list[str]]], name: str) -> str:
    types = dict(names_and_types).get(_node_name(name), [""])
    return types[0]


def _ends(graph: Snapshot, name: str, kind: EntityKind) -> list[str]:
    return sorted(set(full_names(graph.on(_node_name(name), kind))))


def _publishers(bridge: Bridge, args: dict[str, Any]) -> dict[str, Any]:
    return {"publishers": _ends(bridge.graph(), _word(args, "topic"), EntityKind.PUBLISHER)}


def _subscribers(bridge: Bridge, args: dict[str, Any]) -> dict[str, Any]:
    return {"subscribers": _ends(bridge.graph(), _word(args, "topic"), EntityKind.SUBSCRIPTION)}


def _service_providers(bridge: Bridge, args: dict[str, Any]) -> dict[str, Any]:
    # rosapi takes the type of services. Its documentation says name, so a name works too.
    graph, word = bridge.graph(), _word(args, "service")
    names = [name for name, types in graph.services() if word in types] or [word]
    return {
        "providers": sorted(
            {n for service in names for n in _ends(graph, service, EntityKind.SERVICE)}
        )
    }


def _service_node(bridge: Bridge, args: dict[str, Any]) -> dict[str, Any]:
    nodes = _ends(bridge.graph(), _word(args, "service"), EntityKind.SERVICE)
    return {"node": nodes[0] if nodes else ""}


def _interfaces(_bridge: Bridge, _args: dict[str, Any]) -> dict[str, Any]:
    return {"interfaces": [name for package in packages() for name in interface_names(package)]}


def _message_details(bridge: Bridge, args: dict[str, Any]) -> dict[str, Any]:
    return {"typedefs": type_details(bridge.interface("msg", _word(args, "type")))}


def _part_details(kind: str, part: str) -> Procedure:
    def procedure(bridge: Bridge, args: dict[str, Any]) -> dict[str, Any]:
        whole = bridge.interface(kind, _word(args, "type"))
        return {"typedefs": type_details(getattr(whole, part))}

    return procedure


def _get_param(bridge: Bridge, args: dict[str, Any]) -> dict[str, Any]:
    name, default = _word(args, "name"), _word(args, "default_value", "")
    value = _parameters(bridge).value(*_split(name)).value
    if value is not None:
        return {"value": json.dumps(json_value(value)), "successful": True, "reason": ""}
    is_given = default != ""
    reason = "" if is_given else f"the parameter {name} is not set"
    return {"value": default or "null", "successful": is_given, "reason": reason}


def _has_param(bridge: Bridge, args: dict[str, Any]) -> dict[str, Any]:
    return {"exists": _parameters(bridge).value(*_split(_word(args, "name"))).value is not None}


def _set_param(bridge: Bridge, args: dict[str, Any]) -> dict[str, Any]:
    node, name = _split(_word(args, "name"))
    parameter = parameter_from_json(name, _word(args, "value"))
    _check_writable(bridge)
    return _set(bridge, node, _parameters(bridge).from_json(node, name, parameter.value))


def parameter_from_json(name: str, text: str) -> Parameter[Any]:
    """Return a parameter whose value is given as JSON.

    Raises:
        RosbridgeError: The text is not JSON, or a parameter cannot have the value.
    """
    try:
        return Parameter(name, value=read_json(text))
    except JsonError as error:
        raise RosbridgeError(f"the argument 'value' must be JSON: {error.reason}") from error
    except ZbotError as error:
        raise RosbridgeError(str(error)) from error


def _delete_param(bridge: Bridge, args: dict[str, Any]) -> dict[str, Any]:
    node, name = _split(_word(args, "name"))
    _check_writable(bridge)
    return _set(bridge, node, Parameter(name))


def _check_writable(bridge: Bridge) -> None:
    if bridge.is_read_only:
        raise RosbridgeError("setting parameters is not possible: zbot web runs with --read-only")


def _set(bridge: Bridge, node: str, parameter: Parameter[Any]) -> dict[str, Any]:
    (result,) = _parameters(bridge).set(node, [parameter])
    return {"successful": result.successful, "reason": result.reason}


def _parameters(bridge: Bridge) -> RemoteParameters:
    return RemoteParameters(ServiceCalls(bridge.node, answer_timeout_s=_PATIENCE_S))


def _split(name: str) -> tuple[str, str]:
    node, colon, parameter = name.partition(":")
    if not colon or not node or not parameter:
        raise RosbridgeError(
            f"{name!r} is not the name of a parameter: write it as /node:parameter"
        )
    return _node_name(node), parameter


def _get_param_names(bridge: Bridge, _args: dict[str, Any]) -> dict[str, Any]:
    """Ask all nodes for the names of their parameters. Leave out nodes without an answer."""
    nodes = nodes_with_parameters(bridge.graph(), include_hidden=True)
    found = _parameters(bridge).all_names(nodes).found
    return {"names": [f"{node}:{name}" for node, names in found.items() for name in names]}


def _get_time(bridge: Bridge, _args: dict[str, Any]) -> dict[str, Any]:
    now = bridge.now()
    # roslibpy reads ROS 1's names of the fields.
    return {"time": {**json_value(now), "secs": now.sec, "nsecs": now.nanosec}}


def _get_ros_version(_bridge: Bridge, _args: dict[str, Any]) -> dict[str, Any]:
    return {"version": 2, "distro": "zbot"}


#: The functions that answer the services, by the full names of the services.
PROCEDURES: dict[str, Procedure] = {
    f"/rosapi/{name}": procedure
    for name, procedure in {
        "topics": _topics,
        "topics_for_type": _topics_for_type,
        "topics_and_raw_types": _topics_and_raw_types,
        "services": _services,
        "services_for_type": _services_for_type,
        "nodes": _nodes,
        "node_details": _node_details,
        "action_servers": _action_servers,
        "topic_type": _topic_type,
        "service_type": _service_type,
        "action_type": _action_type,
        "publishers": _publishers,
        "subscribers": _subscribers,
        "service_providers": _service_providers,
        "service_node": _service_node,
        "interfaces": _interfaces,
        "message_details": _message_details,
        "service_request_details": _part_details("srv", "Request"),
        "service_response_details": _part_details("srv", "Response"),
        "action_goal_details": _part_details("action", "Goal"),
        "action_result_details": _part_details("action", "Result"),
        "action_feedback_details": _part_details("action", "Feedback"),
        "get_param": _get_param,
        "has_param": _has_param,
        "set_param": _set_param,
        "delete_param": _delete_param,
        "get_param_names": _get_param_names,
        "get_time": _get_time,
        "get_ros_version": _get_ros_version,
    }.items()
}
