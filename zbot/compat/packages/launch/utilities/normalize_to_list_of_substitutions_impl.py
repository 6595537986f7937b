"""Names of `launch.utilities` under the name of their own module."""

from zbot.launch.substitution import normalize as normalize_to_list_of_substitutions

__all__ = ["normalize_to_list_of_substitutions"]
