"""Substitution for the value of a Python expression."""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

from zbot.launch.errors import SubstitutionError, UnknownNameError, describe
from zbot.launch.substitution import Substitution, normalize, perform
from zbot.launch.substitution import describe as describe_substitutions

if TYPE_CHECKING:
    from zbot.launch.context import LaunchContext
    from zbot.launch.substitution import SomeSubstitutionsType


class PythonExpression(Substitution):
    """The value of a Python expression, as text.

    Args:
        expression: The expression.
        python_modules: Modules that the expression may use, as a list or separated by commas.
            The names in `math` also work without `math.`.
    """

    def __init__(
        self,
        expression: SomeSubstitutionsType,
        python_modules: SomeSubstitutionsType = ("math",),
    ) -> None:
        self.expression = normalize(expression)
        given: Any = python_modules
        modules = [given] if isinstance(given, (str, Substitution)) else given
        self.python_modules = [normalize(module) for module in modules]

    def perform(self, context: LaunchContext) -> str:
        """Return the value.

        Raises:
            SubstitutionError: The expression raises an error, or a module cannot be imported.
            UnknownNameError: A name in the expression is undefined.
        """
        text = perform(context, self.expression)
        try:
            return str(eval(text, self._names(context)))  # noqa: S307 - the user's own launch file
        except Exception as error:
            kind = UnknownNameError if isinstance(error, NameError) else SubstitutionError
            raise kind(f"cannot evaluate `{text}`: {describe(error)}") from error

    def _names(self, context: LaunchContext) -> dict[str, Any]:
        names: dict[str, Any] = {}
        texts = (perform(context, module) for module in self.python_modules)
        for name in (part.strip() for text in texts for part in text.split(",") if part.strip()):
            imported = importlib.import_module(name)
            names[name.partition(".")[0]] = importlib.import_module(name.partition(".")[0])
            if name == "math":
                names.update({key: vars(imported)[key] for key in vars(imported) if key[0] != "_"})
        return names

    def describe(self) -> str:
        """Return the expression."""
        return f"PythonExpr({describe_substitutions(self.expression)})"
