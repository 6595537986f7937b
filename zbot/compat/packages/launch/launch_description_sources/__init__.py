"""Sources of launch descriptions."""

from zbot.compat.submodules import submodules
from zbot.launch.errors import InvalidLaunchFileError
from zbot.launch.errors import LaunchFileError as InvalidPythonLaunchFileError
from zbot.launch.frontend.errors import InvalidFrontendLaunchFileError
from zbot.launch.python_file import load_module as load_python_launch_file_as_module
from zbot.launch.source import (
    AnyLaunchDescriptionSource,
    FrontendLaunchDescriptionSource,
    PythonLaunchDescriptionSource,
)
from zbot.launch.source import load_launch_file as get_launch_description_from_any_launch_file
from zbot.launch.source import load_launch_file as get_launch_description_from_frontend_launch_file
from zbot.launch.source import (
    load_python_launch_file as get_launch_description_from_python_launch_file,
)

__getattr__ = submodules(
    __name__,
    "any_launch_file_utilities",
    "frontend_launch_file_utilities",
    "python_launch_file_utilities",
)
