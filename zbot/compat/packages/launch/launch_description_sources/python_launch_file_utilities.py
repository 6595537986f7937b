"""Launch files in Python."""

from zbot.launch.errors import LaunchFileError as InvalidPythonLaunchFileError
from zbot.launch.source import (
    load_python_launch_file as get_launch_description_from_python_launch_file,
)
