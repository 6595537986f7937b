# Written by python -m zbot.compat.generator; do not edit.
"""Helpers for launch files that define their own actions."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names
from zbot.launch.signal_manager import AsyncSafeSignalManager
from zbot.launch.substitution import (
    is_a_substitution,
    normalize as normalize_to_list_of_substitutions,
    perform as perform_substitutions,
)
from zbot.compat.launch_utilities import (
    create_future,
    ensure_argument_type,
    is_a,
    is_a_subclass,
    isclassinstance,
    visit_all_entities_and_collect_futures,
)

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

if TYPE_CHECKING:
    from . import class_tools_impl as class_tools_impl
    from . import create_future_impl as create_future_impl
    from . import ensure_argument_type_impl as ensure_argument_type_impl
    from . import normalize_to_list_of_substitutions_impl as normalize_to_list_of_substitutions_impl
    from . import perform_substitutions_impl as perform_substitutions_impl
    from . import shutdown_on_process_exit as shutdown_on_process_exit
    from . import signal_management as signal_management
    from . import type_utils as type_utils
    from . import typing_file_path as typing_file_path
    from . import visit_all_entities_and_collect_futures_impl as visit_all_entities_and_collect_futures_impl
else:
    __getattr__ = lazy_names(
        __name__,
        {
        },
        submodules=(
            "class_tools_impl",
            "create_future_impl",
            "ensure_argument_type_impl",
            "normalize_to_list_of_substitutions_impl",
            "perform_substitutions_impl",
            "shutdown_on_process_exit",
            "signal_management",
            "type_utils",
            "typing_file_path",
            "visit_all_entities_and_collect_futures_impl",
        ),
    )[0]
