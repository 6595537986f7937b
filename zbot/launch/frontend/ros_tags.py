"""Tags of `launch_ros` for nodes with their parameters, remaps and namespaces."""

from __future__ import annotations

import re
from functools import partial
from typing import TYPE_CHECKING, Any

from zbot.errors import ZbotError
from zbot.launch import actions
from zbot.launch.actions.composable import ComposableNode
from zbot.launch.actions.gazebo import GazeboAction, GzServer, GzSpawnModel, RosGzBridge
from zbot.launch.frontend.registry import action, expose_action
from zbot.launch.frontend.tags import (
    add_plain_tags,
    boolean,
    process_options,
    required_text,
    text,
    words,
)
from zbot.launch.parameters import ParameterFile, ParameterValue
from zbot.launch.substitution import TextSubstitution
from zbot.launch.typed_value import TYPES_BY_NAME
from zbot.parameters.file import parse_value

if TYPE_CHECKING:
    from zbot.launch.action import Action
    from zbot.launch.frontend.entity import Entity
    from zbot.launch.frontend.parser import Parser

_TYPES: dict[str, Any] = {**TYPES_BY_NAME, "double": float, "string": str}


def _parameters(entity: Entity, parser: Parser) -> list[Any]:
    found: list[Any] = []
    for child in entity.children_of_type("param"):
        file = text(child, parser, "from")
        if file is None:
            found.append(_named(child, parser))
        else:
            substitutes = boolean(child, "allow_substs", default=False)
            found.append(ParameterFile(file, allow_substs=substitutes))
        child.assert_entity_completely_parsed()
    return found


def _named(entity: Entity, parser: Parser) -> dict[Any, Any]:
    name = required_text(entity, parser, "name")
    nested = entity.children_of_type("param")
    if not nested:
        return {tuple(name): _value(entity, parser)}
    values: dict[Any, Any] = {}
    for child in nested:
        values.update(_named(child, parser))
        child.assert_entity_completely_parsed()
    return {tuple(name): values}


def _value(entity: Entity, parser: Parser) -> Any:
    value = entity.value("value")
    if value is None:
        raise entity.error("`param` needs the attribute 'value' or a nested `param`")
    separator, kind = entity.text("value-sep"), entity.text("type")
    if kind is not None:
        value = entity.written("value")
    parse = _scalar if kind is None else _text_parts
    if separator is not None and isinstance(value, str):
        pattern = re.escape(separator)
        value = [parse(part.strip(), parser) for part in re.split(pattern, value)]
    elif isinstance(value, str):
        value = parse(value, parser)
    elif kind is not None:
        value = [parse(item, parser) for item in value]
    if kind is None:
        return value
    if kind not in _TYPES:
        raise entity.error(f"'type' must be one of {', '.join(_TYPES)}, not '{kind}'")
    return ParameterValue(value, value_type=_TYPES[kind])


def _text_parts(value: str, parser: Parser) -> Any:
    return parser.parse_substitution(value)


def _scalar(value: str, parser: Parser) -> Any:
    """Return the substitutions of a text, or the YAML value of a text without substitutions.

    A value in YAML quotes is a string. An escaped quote is part of the string.
    """
    parts = parser.parse_substitution(value)
    if not all(isinstance(part, TextSubstitution) for part in parts):
        return parts
    try:
        read = parse_value(value) if value.strip() else value
    except ZbotError:  # text such as `''2''` is not YAML
        is_quoted = len(value) > 1 and value[0] == value[-1] == "'"
        read = value[1:-1] if is_quoted else value
    if not isinstance(read, str):
        return read
    texts = [part for part in parser.parse_substitution(read) if isinstance(part, TextSubstitution)]
    return "".join(part.text for part in texts)


def _remaps(entity: Entity, parser: Parser) -> list[Any]:
    return [
        (required_text(child, parser, "from"), required_text(child, parser, "to"))
        for child in entity.children_of_type("remap")
    ]


def node_options(entity: Entity, parser: Parser) -> dict[str, Any]:
    """Return the constructor options of `Node` for a `node` tag."""
    options = {
        "package": text(entity, parser, "pkg"),
        "executable": required_text(entity, parser, "exec"),
        "name": text(entity, parser, "name"),
        "namespace": text(entity, parser, "namespace"),
        "exec_name": text(entity, parser, "exec_name"),
        "parameters": _parameters(entity, parser),
        "remappings": _remaps(entity, parser),
        **process_options(entity, parser),
    }
    for attribute, option in (("args", "arguments"), ("ros_args", "ros_arguments")):
        value = text(entity, parser, attribute)
        if value is not None:
            options[option] = words(value)
    return options


def lifecycle_node_options(entity: Entity, parser: Parser) -> dict[str, Any]:
    """Return the constructor options of `LifecycleNode` for a `lifecycle_node` tag."""
    entity.required("name")
    options = node_options(entity, parser)
    options["namespace"] = options["namespace"] or ""
    return {**options, "autostart": boolean(entity, "autostart", default=False)}


expose_action("node")(actions.Node)
expose_action("lifecycle_node")(actions.LifecycleNode)
add_plain_tags(
    {
        "push_ros_namespace": (actions.PushROSNamespace, "namespace"),
        "set_remap": (actions.SetRemap, "from", "to"),
        "set_use_sim_time": (actions.SetUseSimTime, "value"),
        "set_ros_log_dir": (actions.SetROSLogDir, "new_log_dir"),
    }
)


@action("set_parameter")
def _set_parameter(entity: Entity, parser: Parser) -> Action:
    return actions.SetParameter(required_text(entity, parser, "name"), _value(entity, parser))


@action("set_parameters_from_file")
def _set_parameters(entity: Entity, parser: Parser) -> Action:
    return actions.SetParametersFromFile(
        required_text(entity, parser, "filename"), node_name=text(entity, parser, "node")
    )


@action("ros_timer")
def _ros_timer(entity: Entity, parser: Parser) -> Action:
    period = parser.parse_if_substitutions(entity.get_attr("period", data_type=float))
    return actions.RosTimer(period=period, actions=parser.actions(entity))


def _components(entity: Entity, parser: Parser) -> list[ComposableNode]:
    found: list[ComposableNode] = []
    for child in entity.children_of_type("composable_node"):
        found.append(
            ComposableNode(
                package=required_text(child, parser, "pkg"),
                plugin=required_text(child, parser, "plugin"),
                name=text(child, parser, "name"),
                namespace=text(child, parser, "namespace"),
                parameters=_parameters(child, parser),
                remappings=_remaps(child, parser),
                condition=parser.condition(child),
            )
        )
        child.children_of_type("extra_arg")
    return found


@action("node_container")
def _node_container(entity: Entity, parser: Parser) -> Action:
    options = node_options(entity, parser)
    return actions.ComposableNodeContainer(
        name=options["name"] or "",
        namespace=options["namespace"] or "",
        composable_node_descriptions=_components(entity, parser),
    )


@action("load_composable_node")
def _load_components(entity: Entity, parser: Parser) -> Action:
    return actions.LoadComposableNodes(
        composable_node_descriptions=_components(entity, parser),
        target_container=required_text(entity, parser, "target"),
    )


def _gazebo(kind: type[GazeboAction], entity: Entity, parser: Parser) -> Action:
    given: dict[str, Any] = {name: text(entity, parser, name) for name in kind.known()}
    return kind(**given)


_GAZEBO = {"ros_gz_bridge": RosGzBridge, "gz_server": GzServer, "gz_spawn_model": GzSpawnModel}
for _tag, _kind in _GAZEBO.items():
    action(_tag)(partial(_gazebo, _kind))
