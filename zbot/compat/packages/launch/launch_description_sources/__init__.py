"""Sources of launch descriptions."""

from zbot.compat.submodules import submodules
from zbot.launch.errors import LaunchFileError as InvalidPythonLaunchFileError
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

__getattr__ = submodules(__name__, "any_launch_file_utilities", "python_launch_file_utilities")
