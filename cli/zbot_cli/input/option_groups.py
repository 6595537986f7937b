"""Option groups that several verbs share. A group is a dataclass whose fields are options.

A verb takes a group as one parameter, whose default is an instance of the dataclass:

    @app.command("list")
    @with_option_groups
    def list_topics(as_json: AsJson = False, daemon: DaemonOptions = NO_DAEMON) -> None: ...
"""

from __future__ import annotations

import functools
import inspect
from dataclasses import is_dataclass
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Callable

    import typer


def noun_option(ctx: typer.Context, name: str) -> bool:
    """Return whether a flag is before the verb, as in `zbot topic --include-hidden-topics list`."""
    return ctx.parent is not None and bool(ctx.parent.params[name])


class with_option_groups:  # noqa: N801 - a decorator
    """Wrapper of a verb. typer sees each field of the verb's option groups as a parameter.

    The signature is built when typer reads `__signature__`. Building a signature takes a
    millisecond, and a command line runs only one verb of a module.
    """

    def __init__(self, verb: Callable[..., None]) -> None:
        self._verb = verb
        functools.update_wrapper(self, verb)
        self.__annotations__ = verb.__annotations__

    @functools.cached_property
    def _parameters(self) -> dict[str, inspect.Parameter]:
        return dict(inspect.signature(self._verb, eval_str=True).parameters)

    @functools.cached_property
    def __signature__(self) -> inspect.Signature:
        parameters: list[inspect.Parameter] = []
        for parameter in self._parameters.values():
            group = _group_of(parameter)
            parameters += [parameter] if group is None else _options_of(group)
        return inspect.Signature(parameters)

    def __call__(self, **values: Any) -> None:
        """Run the verb. For each group, it gets one object with the values of the options."""
        for name, parameter in self._parameters.items():
            group = _group_of(parameter)
            if group is not None:
                options = {option.name: values.pop(option.name) for option in _options_of(group)}
                values[name] = group(**options)
        self._verb(**values)


def _group_of(parameter: inspect.Parameter) -> Any:
    return type(parameter.default) if is_dataclass(parameter.default) else None


@functools.cache
def _options_of(group: Any) -> tuple[inspect.Parameter, ...]:
    return tuple(inspect.signature(group, eval_str=True).parameters.values())
