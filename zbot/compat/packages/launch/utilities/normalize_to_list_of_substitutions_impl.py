"""What `launch.utilities` has, under its own module's name."""

from zbot.launch.substitution import normalize as normalize_to_list_of_substitutions

__all__ = ["normalize_to_list_of_substitutions"]
