"""Command whose options take several values, as in argparse: `--dependencies rclpy std_msgs`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, ClassVar

from typer.core import TyperCommand

if TYPE_CHECKING:
    from collections.abc import Iterator


class ManyValuesCommand(TyperCommand):
    """Command with options that take all words up to the next option."""

    #: Options that take all words up to the next word that begins with a dash.
    many: ClassVar[frozenset[str]] = frozenset()
    #: Options that take all words up to the next option of this command. Among these words, some
    #: may begin with a dash.
    verbatim: ClassVar[frozenset[str]] = frozenset()

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        """Repeat each option before each of its values, and then parse the words."""
        return super().parse_args(ctx, list(self._repeat_options(args)))

    def _repeat_options(self, words: list[str]) -> Iterator[str]:
        own = {text for parameter in self.params for text in parameter.opts}
        open_option = ""
        for word in words:
            if word in self.many | self.verbatim:
                open_option = word
            elif word in own or not self._takes(open_option, word):
                open_option = ""
                yield word
            else:
                yield (
                    f"{open_option}={word}" if open_option.startswith("--") else open_option + word
                )

    def _takes(self, option: str, word: str) -> bool:
        return option in self.verbatim or (option in self.many and not word.startswith("-"))
