"""`zbot complete`: prints the possible next words of a command line, for Tab in a shell.

It takes options from the commands, names from the running nodes, and types from this machine.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import TYPE_CHECKING, Any

from zbot.errors import ZbotError
from zbot_cli.output.exit_status import Status

if TYPE_CHECKING:
    from zbot.graph.snapshot import Snapshot
    from zbot_cli.domain.kinds import Kind

#: Function that returns the candidates for a word, from the finished arguments and this word.
_Source = Callable[[Sequence[str], str], Iterable[str]]

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
    for candidate in sorted({text for text in found if text.startswith(unfinished)}):
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
        name
        for parameter in verb.params
        if not getattr(parameter, "is_flag", True)
        for name in parameter.opts
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
    shown = [parameter for parameter in command.params if not getattr(parameter, "hidden", False)]
    return [name for parameter in shown for name in parameter.opts if name.startswith("--")]


def _executables(done: Sequence[str]) -> Iterable[str]:
    from zbot_cli.packages.executables import all_packages  # noqa: PLC0415 - needed only for `run`

    packages = [package for package in all_packages() if package.executables]
    if not done:
        names = {executable.name for package in packages for executable in package.executables}
        return names | {package.name for package in packages}
    inside = [package.executables for package in packages if package.name == done[0]]
    return {executable.name for group in inside for executable in group} if len(done) == 1 else []


def _launch_files(done: Sequence[str], unfinished: str) -> Iterable[str]:
    import zbot.compat  # noqa: F401, PLC0415 - launch files import ROS 2's names
    from zbot_cli.packages.launch_file import candidates, paths  # noqa: PLC0415 - needed only for `launch`

    words = [word for word in done if not word.startswith("-")]
    return [*candidates(words), *(() if words else paths(unfinished))]


def _live_names(read: Callable[[Snapshot, str], Iterable[str]]) -> _Source:
    """Return the source of the names that a function reads from the graph.

    The function also gets the unfinished word. If this word does not begin with a slash, the names
    do not either.
    """

    def source(_: Sequence[str], unfinished: str) -> Iterable[str]:
        from zbot_cli.domain.client import snapshot  # noqa: PLC0415 - needed only for live names

        names = read(snapshot(), unfinished)
        is_full = unfinished.startswith("/") or not unfinished
        return names if is_full else [name[1:] for name in names]

    return source


def _node_names(graph: Snapshot, _: str) -> Iterable[str]:
    from zbot.graph.snapshot import full_names  # noqa: PLC0415 - needed only for live names

    return full_names(graph.nodes)


def _managed_node_names(graph: Snapshot, unfinished: str) -> Iterable[str]:
    from zbot.remote.managed_nodes import managed_nodes  # noqa: PLC0415 - needed only for live names

    return managed_nodes(graph, include_hidden=unfinished.lstrip("/").startswith("_"))


def _kind(word: str) -> Kind:
    from zbot_cli.domain.kinds import KINDS  # noqa: PLC0415 - needed only for these nouns

    return KINDS[word]


def _names(word: str) -> _Source:
    """Return the source of the names of a kind, e.g. of all topics."""
    return _live_names(lambda graph, _: [name for name, _ in _kind(word).listed(graph)])


def _types(word: str) -> _Source:
    """Return the source of the types of a kind, e.g. of all message types."""
    return lambda _, __: _kind(word).all_types()


def _type_of_name(word: str) -> _Source:
    """Return the source of the types of the name on the command line. Or else, of all types."""

    def source(done: Sequence[str], _: str) -> Iterable[str]:
        from zbot_cli.domain.client import full_name, snapshot  # noqa: PLC0415 - only for live names

        kind = _kind(word)
        found = dict(kind.listed(snapshot())).get(full_name(done[0])) if done else None
        return found or kind.all_types()

    return source


def _default_values(word: str) -> _Source:
    """Return the source of the default values of the type on the command line, as JSON."""

    def source(done: Sequence[str], _: str) -> Iterable[str]:
        import json  # noqa: PLC0415 - needed only for values

        from zbot.interfaces.plain_value import json_value  # noqa: PLC0415 - as above

        kind = _kind(word)
        try:
            values = kind.values_of(kind.load(done[1]))()
        except (ZbotError, IndexError):
            return []
        return [f"'{json.dumps(json_value(values))}'"]

    return source


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


def _nothing(_: Sequence[str], __: str) -> Iterable[str]:
    return ()


def _fields(done: Sequence[str], _: str) -> Iterable[str]:
    """Return the fields of a topic's messages, e.g. `pose.position.x`."""
    types = done[1:2] or list(_type_of_name("topic")(done, "") if done else [])
    return _field_paths(_kind("topic").class_of(types[0]), "") if len(types) == 1 else []


def _field_paths(message_type: Any, prefix: str) -> Iterable[str]:
    from zbot.interfaces import get_message  # noqa: PLC0415 - needed only for `--field`

    for field in message_type._SPEC.fields:  # noqa: SLF001 - our own class
        yield prefix + field.name
        if field.type.is_message and field.type.kind == "scalar":
            yield from _field_paths(get_message(field.type.base), f"{prefix}{field.name}.")


def _profiles(_: Sequence[str], __: str) -> Iterable[str]:
    from zbot.qos import QoSPresetProfiles  # noqa: PLC0415 - needed only for `--qos-profile`

    return QoSPresetProfiles.short_keys()


def _choices(*words: str) -> _Source:
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


_NODES = _live_names(_node_names)
_MANAGED = _live_names(_managed_node_names)
_TRANSITIONS = _choices("configure", "cleanup", "activate", "deactivate", "shutdown")
_SHELLS = _choices("bash", "zsh", "fish", "powershell")
#: For each verb, the functions that return candidates for its first argument, its second argument
#: and so on. The last function also returns the candidates for all later arguments.
_VALUES: dict[tuple[str, str], tuple[_Source | None, ...]] = {
    ("action", "echo"): (_names("action"), _type_of_name("action")),
    ("action", "find"): (_types("action"),),
    ("action", "info"): (_names("action"),),
    ("action", "send_goal"): (_names("action"), _type_of_name("action"), _default_values("action")),
    ("action", "type"): (_names("action"),),
    ("bag", "record"): (_names("topic"),),
    ("lifecycle", "get"): (_MANAGED,),
    ("lifecycle", "list"): (_MANAGED,),
    ("lifecycle", "set"): (_MANAGED, _TRANSITIONS),
    ("param", "delete"): (_NODES, _parameters),
    ("param", "describe"): (_NODES, _parameters),
    ("param", "dump"): (_NODES,),
    ("param", "get"): (_NODES, _parameters),
    ("param", "list"): (_NODES,),
    ("param", "load"): (_NODES, None),
    ("param", "set"): (_NODES, _parameter_to_set),
    ("pkg", "deps"): (_all_packages,),
    ("pkg", "executables"): (_all_packages,),
    ("pkg", "prefix"): (_all_packages,),
    ("pkg", "xml"): (_all_packages,),
    ("service", "call"): (_names("service"), _type_of_name("service"), _default_values("service")),
    ("service", "echo"): (_names("service"), _type_of_name("service")),
    ("service", "find"): (_types("service"),),
    ("service", "info"): (_names("service"),),
    ("service", "type"): (_names("service"),),
    ("topic", "echo"): (_names("topic"), _type_of_name("topic")),
    ("topic", "pub"): (_names("topic"), _type_of_name("topic"), _default_values("topic")),
    ("topic", "info"): (_names("topic"),),
    ("topic", "type"): (_names("topic"),),
    ("topic", "hz"): (_names("topic"),),
    ("topic", "bw"): (_names("topic"),),
    ("topic", "delay"): (_names("topic"),),
    ("topic", "find"): (_types("topic"),),
    ("node", "info"): (_NODES,),
    ("node", "kill"): (_NODES,),
    ("interface", "show"): (_all_types,),
    ("interface", "proto"): (_all_types,),
    ("interface", "package"): (_packages,),
    ("interface", "remove"): (_added_packages,),
    ("completion", ""): (_SHELLS,),
    ("setup-shell", ""): (_SHELLS,),
}
