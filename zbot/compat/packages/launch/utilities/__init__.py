"""Helpers for launch files that define their own actions."""

from zbot.launch.argument_check import (
    ensure_argument_type,
    is_a,
    is_a_subclass,
    isclassinstance,
)
from zbot.launch.signal_manager import AsyncSafeSignalManager
from zbot.launch.substitution import is_a_substitution
from zbot.launch.substitution import normalize as normalize_to_list_of_substitutions
from zbot.launch.substitution import perform as perform_substitutions
from zbot.launch.visit import create_future, visit_all_entities_and_collect_futures

__all__ = [
    "AsyncSafeSignalManager",
    "create_future",
    "ensure_argument_type",
    "is_a",
    "is_a_subclass",
    "is_a_substitution",
    "isclassinstance",
    "normalize_to_list_of_substitutions",
    "perform_substitutions",
    "visit_all_entities_and_collect_futures",
]
