"""Names of `launch.utilities` under the name of their own module."""

from zbot.launch.substitution import perform as perform_substitutions

__all__ = ["perform_substitutions"]
