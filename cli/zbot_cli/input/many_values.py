"""Options with any number of values, as argparse has them: `--dependencies rclpy std_msgs`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, ClassVar

from typer.core import TyperCommand

if TYPE_CHECKING:
    from collections.abc import Iterator


class ManyValuesCommand(TyperCommand):
    """A command with options that go on until the next option."""

    #: Options that take every word up to the next one that begins with a dash.
    many: ClassVar[frozenset[str]] = frozenset()
    #: Options that take every word up to the next one that is an option of this command.
    verbatim: ClassVar[frozenset[str]] = frozenset()

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        """Read the words; several values of one option become as many options."""
        return super().parse_args(ctx, list(self._spread(args)))

    def _spread(self, words: list[str]) -> Iterator[str]:
        own = {text for parameter in self.params for text in parameter.opts}
        open_option = ""
        for word in words:
            if word in self.many | self.verbatim:
                open_option = word
            elif word in own or not self._goes_on(open_option, word):
                open_option = ""
                yield word
            else:
                yield (
                    f"{open_option}={word}" if open_option.startswith("--") else open_option + word
                )

    def _goes_on(self, option: str, word: str) -> bool:
        return option in self.verbatim or (option in self.many and not word.startswith("-"))
