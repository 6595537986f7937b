"""`zbot complete`: prints the possible next words of a command line, for Tab in a shell.

It takes options from the commands, names from the running nodes, and types from this machine.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.errors import ZbotError
from zbot_cli.output.exit_status import Status

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

# Old versions of PowerShell drop an empty word. So zbot's script sends two quotation marks instead.
_EMPTY = ('""', "''")


def complete(words: list[str], nouns: Iterable[str]) -> int:
    """Print the candidates for the last word, each on its own line.

    Args:
        words: The words after `zbot`: an optional `--`, finished words, and the unfinished word.
        nouns: All nouns, e.g. `topic` in `zbot topic list`.
    """
    words = words[1:] if words[:1] == ["--"] else words
    unfinished = words[-1] if words else ""
    if unfinished in _EMPTY:
        unfinished = ""
    try:
        found = _candidates(words[:-1], unfinished, nouns)
    except ZbotError:
        found = []  # a shell cannot show an error message while the user types
    for candidate in sorted({one for one in found if one.startswith(unfinished)}):
        print(candidate)
    return Status.OK


def _candidates(done: Sequence[str], unfinished: str, nouns: Iterable[str]) -> Iterable[str]:
    if not done:
        return (
            ["--help", "--version", "--config", "--debug", "--domain", "--rmw"]
            if unfinished.startswith("-")
            else nouns
        )
    if done[0] == "run":
        return _executables(done[1:])
    if done[0] == "launch" and not unfinished.startswith("-"):
        return _launch_files(done[1:], unfinished)
    if done[0] not in nouns:
        return []
    from zbot_cli.nouns import load, verbs  # noqa: PLC0415 - not needed by `zbot run`

    command = load(done[0])
    known = verbs(command)
    if known and len(done) == 1:
        return _options(command) if unfinished.startswith("-") else known
    verb = known.get(done[1]) if known else command
    if verb is None:
        return []
    if unfinished.startswith("-"):
        return _options(verb)
    positions, option = _split(verb, done[2:] if known else done[1:])
    if option:
        found: Iterable[str] = _OPTION_VALUES.get(option, _nothing)(positions, unfinished)
        return found
    values = _VALUES.get((done[0], done[1] if len(done) > 1 else ""), ())
    source = values[min(len(positions), len(values) - 1)] if values else None
    return source(positions, unfinished) if source is not None else []


def _split(verb: Any, words: Sequence[str]) -> tuple[list[str], str]:
    """Return the arguments among the words, and the option whose value comes next.

    Options and their values are not arguments. The option is an empty string if the last word is
    not an option that needs a value.
    """
    with_value = {
        name for one in verb.params if not getattr(one, "is_flag", True) for name in one.opts
    }
    positions: list[str] = []
    option = ""
    for word in words:
        if option:
            option = ""
        elif word.startswith("-"):
            option = word if word in with_value else ""
        else:
            positions.append(word)
    return positions, option


def _options(command: Any) -> list[str]:
    shown = [one for one in command.params if not getattr(one, "hidden", False)]
    return [name for one in shown for name in one.opts if name.startswith("--")]


def _executables(done: Sequence[str]) -> Iterable[str]:
    from zbot_cli.packages.executables import all_packages  # noqa: PLC0415 - needed only for `run`

    packages = [package for package in all_packages() if package.executables]
    if not done:
        names = {one.name for package in packages for one in package.executables}
        return names | {package.name for package in packages}
    inside = [package.executables for package in packages if package.name == done[0]]
    return {one.name for group in inside for one in group} if len(done) == 1 else []


def _launch_files(done: Sequence[str], unfinished: str) -> Iterable[str]:
    import zbot.compat  # noqa: F401, PLC0415 - launch files import ROS 2's names
    from zbot_cli.packages.launch_file import candidates, paths  # noqa: PLC0415 - needed only for `launch`

    words = [word for word in done if not word.startswith("-")]
    return [*candidates(words), *(() if words else paths(unfinished))]


def _topics(_: Sequence[str], unfinished: str) -> Iterable[str]:
    from zbot_cli.domain.client import snapshot  # noqa: PLC0415 - needed only for live names

    names = [name for name, _ in snapshot().topics()]
    return names if unfinished.startswith("/") or not unfinished else [name[1:] for name in names]


def _nodes(_: Sequence[str], unfinished: str) -> Iterable[str]:
    from zbot.graph.snapshot import full_names  # noqa: PLC0415 - needed only for live names
    from zbot_cli.domain.client import snapshot  # noqa: PLC0415 - as above

    names = full_names(snapshot().nodes)
    return names if unfinished.startswith("/") or not unfinished else [name[1:] for name in names]


def _managed_nodes(_: Sequence[str], unfinished: str) -> Iterable[str]:
    from zbot.remote.managed_nodes import managed_nodes  # noqa: PLC0415 - needed only for live names
    from zbot_cli.domain.client import snapshot  # noqa: PLC0415 - as above

    names = managed_nodes(snapshot(), include_hidden=unfinished.lstrip("/").startswith("_"))
    return names if unfinished.startswith("/") or not unfinished else [name[1:] for name in names]


def _transitions(_: Sequence[str], __: str) -> Iterable[str]:
    return ("configure", "cleanup", "activate", "deactivate", "shutdown")


def _parameters(done: Sequence[str], _: str) -> Iterable[str]:
    from zbot_cli.domain.client import hidden_node  # noqa: PLC0415 - needed only for live names
    from zbot_cli.domain.parameters import CommandParameters  # noqa: PLC0415 - as above

    with hidden_node("complete") as node:
        remote = CommandParameters(node, 0)
        return filter(_is_plain_word, remote.names(remote.find(done[0])))


def _is_plain_word(name: str) -> bool:
    """Return whether a parameter's name has no characters that are special in a shell."""
    return all(char.isalnum() or char in "_-./" for char in name)


def _parameter_to_set(done: Sequence[str], unfinished: str) -> Iterable[str]:
    # The words are NODE PARAM VALUE PARAM VALUE. Values cannot be completed.
    return _parameters(done, unfinished) if len(done) % 2 else []


def _topic_type(done: Sequence[str], unfinished: str) -> Iterable[str]:
    from zbot_cli.domain.client import full_name, snapshot  # noqa: PLC0415 - only for live names

    found = dict(snapshot().topics()).get(full_name(done[0])) if done else None
    return found or _message_types(done, unfinished)


def _actions(_: Sequence[str], unfinished: str) -> Iterable[str]:
    from zbot_cli.domain.client import snapshot  # noqa: PLC0415 - needed only for live names

    names = [name for name, _ in snapshot().actions()]
    return names if unfinished.startswith("/") or not unfinished else [name[1:] for name in names]


def _action_type(done: Sequence[str], _: str) -> Iterable[str]:
    from zbot_cli.domain.client import full_name, snapshot  # noqa: PLC0415 - only for live names

    found = dict(snapshot().actions()).get(full_name(done[0])) if done else None
    return found or _action_types(done, "")


def _action_types(_: Sequence[str], __: str) -> Iterable[str]:
    from zbot_cli.domain.types import all_types  # noqa: PLC0415 - needed only for types

    return (name for name in all_types() if "/action/" in name)


def _goal(done: Sequence[str], _: str) -> Iterable[str]:
    from zbot.interfaces import get_action  # noqa: PLC0415 - needed only for `send_goal`
    from zbot.interfaces.plain_value import json_value  # noqa: PLC0415 - as above

    try:
        action: Any = get_action(done[1])
        goal = action.Goal()
    except (ZbotError, IndexError):
        return []
    import json  # noqa: PLC0415 - needed only for `send_goal`

    return [f"'{json.dumps(json_value(goal))}'"]


def _message_types(_: Sequence[str], __: str) -> Iterable[str]:
    from zbot_cli.domain.types import all_messages  # noqa: PLC0415 - needed only for types

    return all_messages()


def _all_types(_: Sequence[str], __: str) -> Iterable[str]:
    from zbot_cli.domain.types import all_types  # noqa: PLC0415 - needed only for types

    return all_types()


def _all_packages(_: Sequence[str], __: str) -> Iterable[str]:
    from zbot.package import packages  # noqa: PLC0415 - needed only for `pkg`

    return packages()


def _workspace_packages(_: Sequence[str], __: str) -> Iterable[str]:
    from zbot.package.workspace import build_roots, packages_by_name  # noqa: PLC0415 - needed only for `build`

    return packages_by_name(build_roots())


def _added_packages(_: Sequence[str], __: str) -> Iterable[str]:
    from zbot.interfaces.user_definitions import added_packages  # noqa: PLC0415 - needed only for this verb

    return added_packages()


def _packages(_: Sequence[str], __: str) -> Iterable[str]:
    from zbot.interfaces import packages  # noqa: PLC0415 - needed only for types

    return packages()


def _prototype(done: Sequence[str], _: str) -> Iterable[str]:
    from zbot.interfaces import get_message  # noqa: PLC0415 - needed only for `pub`
    from zbot.interfaces.plain_value import json_value  # noqa: PLC0415 - needed only for `pub`

    try:
        message = get_message(done[1])()
    except (ZbotError, IndexError):
        return []
    import json  # noqa: PLC0415 - needed only for `pub`

    return [f"'{json.dumps(json_value(message))}'"]


def _services(_: Sequence[str], unfinished: str) -> Iterable[str]:
    from zbot_cli.domain.client import snapshot  # noqa: PLC0415 - needed only for live names

    names = [name for name, _ in snapshot().services()]
    return names if unfinished.startswith("/") or not unfinished else [name[1:] for name in names]


def _service_type(done: Sequence[str], _: str) -> Iterable[str]:
    from zbot_cli.domain.client import full_name, snapshot  # noqa: PLC0415 - only for live names

    found = dict(snapshot().services()).get(full_name(done[0])) if done else None
    return found or _service_types(done, "")


def _service_types(_: Sequence[str], __: str) -> Iterable[str]:
    from zbot_cli.domain.types import all_types  # noqa: PLC0415 - needed only for types

    return (name for name in all_types() if "/srv/" in name)


def _request(done: Sequence[str], _: str) -> Iterable[str]:
    from zbot.interfaces import get_service  # noqa: PLC0415 - needed only for `call`
    from zbot.interfaces.plain_value import json_value  # noqa: PLC0415 - as above

    try:
        service: Any = get_service(done[1])
        request = service.Request()
    except (ZbotError, IndexError):
        return []
    import json  # noqa: PLC0415 - needed only for `call`

    return [f"'{json.dumps(json_value(request))}'"]


def _nothing(_: Sequence[str], __: str) -> Iterable[str]:
    return ()


def _fields(done: Sequence[str], _: str) -> Iterable[str]:
    """Return the fields of a topic's messages, e.g. `pose.position.x`."""
    from zbot_cli.domain.topic_types import message_class  # noqa: PLC0415 - needed only for `--field`

    types = done[1:2] or list(_topic_type(done, "") if done else [])
    return _field_paths(message_class(types[0]), "") if len(types) == 1 else []


def _field_paths(message_type: Any, prefix: str) -> Iterable[str]:
    from zbot.interfaces import get_message  # noqa: PLC0415 - needed only for `--field`

    for field in message_type._SPEC.fields:  # noqa: SLF001 - our own class
        yield prefix + field.name
        if field.type.is_message and field.type.kind == "scalar":
            yield from _field_paths(get_message(field.type.base), f"{prefix}{field.name}.")


def _profiles(_: Sequence[str], __: str) -> Iterable[str]:
    from zbot.qos import QoSPresetProfiles  # noqa: PLC0415 - needed only for `--qos-profile`

    return QoSPresetProfiles.short_keys()


def _choices(*words: str) -> Any:
    return lambda _, __: words


#: Functions that return the candidates for the value of an option.
_OPTION_VALUES: dict[str, Any] = {
    "--build-type": _choices("ament_python", "ament_cmake", "cmake"),
    "--field": _fields,
    "--packages-select": _workspace_packages,
    "--packages-skip": _workspace_packages,
    "--packages-up-to": _workspace_packages,
    "--qos-durability": _choices("volatile", "transient_local"),
    "--qos-history": _choices("keep_last", "keep_all"),
    "--qos-liveliness": _choices("automatic", "manual_by_topic"),
    "--qos-profile": _profiles,
    "--qos-reliability": _choices("reliable", "best_effort"),
    "--show": _choices("all", "active", "nodes"),
}


def _shells(_: Sequence[str], __: str) -> Iterable[str]:
    return ("bash", "zsh", "fish", "powershell")


#: For each verb, the functions that return candidates for its first argument, its second argument
#: and so on. The last function also returns the candidates for all later arguments.
_VALUES: dict[tuple[str, str], tuple[Any, ...]] = {
    ("action", "echo"): (_actions, _action_type),
    ("action", "find"): (_action_types,),
    ("action", "info"): (_actions,),
    ("action", "send_goal"): (_actions, _action_type, _goal),
    ("action", "type"): (_actions,),
    ("bag", "record"): (_topics,),
    ("lifecycle", "get"): (_managed_nodes,),
    ("lifecycle", "list"): (_managed_nodes,),
    ("lifecycle", "set"): (_managed_nodes, _transitions),
    ("param", "delete"): (_nodes, _parameters),
    ("param", "describe"): (_nodes, _parameters),
    ("param", "dump"): (_nodes,),
    ("param", "get"): (_nodes, _parameters),
    ("param", "list"): (_nodes,),
    ("param", "load"): (_nodes, None),
    ("param", "set"): (_nodes, _parameter_to_set),
    ("pkg", "deps"): (_all_packages,),
    ("pkg", "executables"): (_all_packages,),
    ("pkg", "prefix"): (_all_packages,),
    ("pkg", "xml"): (_all_packages,),
    ("service", "call"): (_services, _service_type, _request),
    ("service", "echo"): (_services, _service_type),
    ("service", "find"): (_service_types,),
    ("service", "info"): (_services,),
    ("service", "type"): (_services,),
    ("topic", "echo"): (_topics, _topic_type),
    ("topic", "pub"): (_topics, _topic_type, _prototype),
    ("topic", "info"): (_topics,),
    ("topic", "type"): (_topics,),
    ("topic", "hz"): (_topics,),
    ("topic", "bw"): (_topics,),
    ("topic", "delay"): (_topics,),
    ("topic", "find"): (_message_types,),
    ("node", "info"): (_nodes,),
    ("node", "kill"): (_nodes,),
    ("interface", "show"): (_all_types,),
    ("interface", "proto"): (_all_types,),
    ("interface", "package"): (_packages,),
    ("interface", "remove"): (_added_packages,),
    ("completion", ""): (_shells,),
    ("setup-shell", ""): (_shells,),
}
