"""Helpers of launch files that define actions of their own."""

from zbot.launch.argument_check import ensure_argument_type, is_a, is_a_subclass
from zbot.launch.substitution import is_a_substitution
from zbot.launch.substitution import normalize as normalize_to_list_of_substitutions
from zbot.launch.substitution import perform as perform_substitutions

__all__ = [
    "ensure_argument_type",
    "is_a",
    "is_a_subclass",
    "is_a_substitution",
    "normalize_to_list_of_substitutions",
    "perform_substitutions",
]
