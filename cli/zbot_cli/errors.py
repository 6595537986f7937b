"""Error of a command line."""

from __future__ import annotations

from zbot.errors import ZbotError


class CommandError(ZbotError):
    """A command cannot do what its command line says. The message is all that it prints.

    Attributes:
        package: The package that is not here, if the error is about one. The hint then names the
            workspace that has it.
    """

    def __init__(self, text: str, *, hint: str | None = "", package: str | None = None) -> None:
        self.package = package
        super().__init__(text, hint=hint)
