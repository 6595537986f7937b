# Written by python -m zbot.compat.generator; do not edit.
"""Substitutions, whose texts are known only during a launch."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names
from zbot.launch.errors import SubstitutionError as SubstitutionFailure
from zbot.launch.substitutions import (
    AllSubstitution,
    AndSubstitution,
    AnonName,
    AnySubstitution,
    Command,
    EnvironmentVariable,
    EqualsSubstitution,
    FileContent,
    FindExecutable,
    ForEachVar,
    ForLoopIndex,
    IfElseSubstitution,
    IsEmptySubstitution,
    LaunchConfiguration,
    LaunchLogDir,
    LocalSubstitution,
    NotEmptySubstitution,
    NotEqualsSubstitution,
    NotSubstitution,
    OrSubstitution,
    PathJoinSubstitution,
    PathSubstitution,
    PythonExpression,
    StringJoinSubstitution,
    StringStripSubstitution,
    TextSubstitution,
    ThisLaunchFile,
    ThisLaunchFileDir,
)

__all__ = [
    "AllSubstitution",
    "AndSubstitution",
    "AnonName",
    "AnySubstitution",
    "Command",
    "EnvironmentVariable",
    "EqualsSubstitution",
    "FileContent",
    "FindExecutable",
    "ForEachVar",
    "ForLoopIndex",
    "IfElseSubstitution",
    "IsEmptySubstitution",
    "LaunchConfiguration",
    "LaunchLogDir",
    "LocalSubstitution",
    "NotEmptySubstitution",
    "NotEqualsSubstitution",
    "NotSubstitution",
    "OrSubstitution",
    "PathJoinSubstitution",
    "PathSubstitution",
    "PythonExpression",
    "StringJoinSubstitution",
    "StringStripSubstitution",
    "SubstitutionFailure",
    "TextSubstitution",
    "ThisLaunchFile",
    "ThisLaunchFileDir",
]

if TYPE_CHECKING:
    from . import anon_name as anon_name
    from . import boolean_substitution as boolean_substitution
    from . import command as command
    from . import environment_variable as environment_variable
    from . import equals_substitution as equals_substitution
    from . import file_content as file_content
    from . import find_executable as find_executable
    from . import for_loop_var as for_loop_var
    from . import if_else_substitution as if_else_substitution
    from . import is_empty_substitution as is_empty_substitution
    from . import launch_configuration as launch_configuration
    from . import launch_log_dir as launch_log_dir
    from . import local_substitution as local_substitution
    from . import not_empty_substitution as not_empty_substitution
    from . import not_equals_substitution as not_equals_substitution
    from . import path_join_substitution as path_join_substitution
    from . import path_substitution as path_substitution
    from . import python_expression as python_expression
    from . import string_join_substitution as string_join_substitution
    from . import string_strip_substitution as string_strip_substitution
    from . import substitution_failure as substitution_failure
    from . import text_substitution as text_substitution
    from . import this_launch_file as this_launch_file
    from . import this_launch_file_dir as this_launch_file_dir
else:
    __getattr__ = lazy_names(
        __name__,
        {
        },
        submodules=(
            "anon_name",
            "boolean_substitution",
            "command",
            "environment_variable",
            "equals_substitution",
            "file_content",
            "find_executable",
            "for_loop_var",
            "if_else_substitution",
            "is_empty_substitution",
            "launch_configuration",
            "launch_log_dir",
            "local_substitution",
            "not_empty_substitution",
            "not_equals_substitution",
            "path_join_substitution",
            "path_substitution",
            "python_expression",
            "string_join_substitution",
            "string_strip_substitution",
            "substitution_failure",
            "text_substitution",
            "this_launch_file",
            "this_launch_file_dir",
        ),
    )[0]
