"""Helpers of launch files that define actions of their own."""

from zbot.launch.substitution import is_a_substitution
from zbot.launch.substitution import normalize as normalize_to_list_of_substitutions
from zbot.launch.substitution import perform as perform_substitutions

__all__ = ["is_a_substitution", "normalize_to_list_of_substitutions", "perform_substitutions"]
