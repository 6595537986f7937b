"""Actions and their types, from words of the command line or from the graph."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.errors.suggestion import did_you_mean
from zbot_cli.domain.types import all_types, find_types, learn, type_hint
from zbot_cli.errors import CommandError

if TYPE_CHECKING:
    from zbot.graph.snapshot import Snapshot


def invalid_action_type_error(hint: str) -> CommandError:
    """Return the error that a word is not the name of an action type."""
    return CommandError("The passed action type is invalid", hint=hint)


def unknown_action_error(name: str, graph: Snapshot) -> CommandError:
    """Return the error that no action of that name has a server or a client."""
    hint = suggestion(name, graph)
    return CommandError(f"Unknown action '{name}'", hint=hint)


def suggestion(name: str, graph: Snapshot, before: str = "") -> str:
    """Return a question with the most similar action name, or an empty string."""
    return did_you_mean(name, [known for known, _ in graph.actions()], before=before)


def resolve_action_type(word: str) -> str:
    """Return the full name of an action type.

    Raises:
        CommandError: No type has this name, or several types have this short name.
    """
    found = [name for name in find_types(word) if _is_action(name)]
    if len(found) != 1:
        raise invalid_action_type_error(type_hint(word, found, filter(_is_action, all_types())))
    return found[0]


def _is_action(name: str) -> bool:
    return "/action/" in name


def action_class(type_name: str) -> type[Any]:
    """Return an action class. If this machine lacks the definition, ask the nodes for it.

    Raises:
        CommandError: No definition of the type is on this machine or in a node.
    """
    from zbot.interfaces import get_action  # noqa: PLC0415 - not needed by `list`

    try:
        return get_action(type_name)
    except LookupError:
        if learn(type_name):
            return get_action(type_name)
        hint = "put its .action file into a package of your workspace"
        raise invalid_action_type_error(hint) from None


def only_action_type(graph: Snapshot, name: str) -> str | None:
    """Return the type of an action, or `None` if no node uses the action.

    Raises:
        CommandError: The action has more than one type.
    """
    types = dict(graph.actions()).get(name)
    if types is not None and len(types) > 1:
        raise CommandError(
            f"Action '{name}' has more than one type: [{', '.join(types)}]",
            hint=f"add the type that you mean, e.g. {types[0]}",
        )
    return None if types is None else types[0]
