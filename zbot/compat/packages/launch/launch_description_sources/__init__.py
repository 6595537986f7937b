# Written by python -m zbot.compat.generator; do not edit.
"""Sources of launch descriptions."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names
from zbot.launch.errors import (
    InvalidFrontendLaunchFileError,
    InvalidLaunchFileError,
    LaunchFileError as InvalidPythonLaunchFileError,
)
from zbot.launch.python_file import load_module as load_python_launch_file_as_module
from zbot.launch.source import (
    AnyLaunchDescriptionSource,
    FrontendLaunchDescriptionSource,
    PythonLaunchDescriptionSource,
    load_launch_file as get_launch_description_from_any_launch_file,
    load_launch_file as get_launch_description_from_frontend_launch_file,
    load_python_launch_file as get_launch_description_from_python_launch_file,
)

__all__ = [
    "AnyLaunchDescriptionSource",
    "FrontendLaunchDescriptionSource",
    "InvalidFrontendLaunchFileError",
    "InvalidLaunchFileError",
    "InvalidPythonLaunchFileError",
    "PythonLaunchDescriptionSource",
    "get_launch_description_from_any_launch_file",
    "get_launch_description_from_frontend_launch_file",
    "get_launch_description_from_python_launch_file",
    "load_python_launch_file_as_module",
]

if TYPE_CHECKING:
    from . import any_launch_description_source as any_launch_description_source
    from . import any_launch_file_utilities as any_launch_file_utilities
    from . import frontend_launch_description_source as frontend_launch_description_source
    from . import frontend_launch_file_utilities as frontend_launch_file_utilities
    from . import python_launch_description_source as python_launch_description_source
    from . import python_launch_file_utilities as python_launch_file_utilities
else:
    __getattr__ = lazy_names(
        __name__,
        {
        },
        submodules=(
            "any_launch_description_source",
            "any_launch_file_utilities",
            "frontend_launch_description_source",
            "frontend_launch_file_utilities",
            "python_launch_description_source",
            "python_launch_file_utilities",
        ),
    )[0]
