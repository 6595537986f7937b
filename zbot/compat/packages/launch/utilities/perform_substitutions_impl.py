"""What `launch.utilities` has, under its own module's name."""

from zbot.launch.substitution import perform as perform_substitutions

__all__ = ["perform_substitutions"]
