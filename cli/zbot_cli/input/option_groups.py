"""Options that verbs share: a dataclass whose fields are options, taken as one parameter."""

from __future__ import annotations

import functools
import inspect
from dataclasses import is_dataclass
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Callable


def spread(verb: Callable[..., Any]) -> Callable[..., Any]:
    """Return a verb for typer whose groups are options, each group's in the place it has.

    A group is a parameter whose default is an instance of a dataclass; the fields of the dataclass
    are annotated and have defaults, as the parameters of verbs do.
    """
    signature = inspect.signature(verb, eval_str=True)
    groups: dict[str, Any] = {}
    parameters: list[inspect.Parameter] = []
    for name, parameter in signature.parameters.items():
        if is_dataclass(parameter.default):
            groups[name] = type(parameter.default)
            parameters += _options_of(groups[name])
        else:
            parameters.append(parameter)
    if not groups:
        return verb

    @functools.wraps(verb)
    def run(**words: Any) -> Any:
        for name, group in groups.items():
            words[name] = group(**{one.name: words.pop(one.name) for one in _options_of(group)})
        return verb(**words)

    run.__signature__ = signature.replace(parameters=parameters)  # type: ignore[attr-defined]
    return run


@functools.cache
def _options_of(group: Any) -> tuple[inspect.Parameter, ...]:
    return tuple(inspect.signature(group, eval_str=True).parameters.values())
