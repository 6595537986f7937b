"""Launch files in XML and YAML."""

from zbot.launch.frontend.errors import InvalidFrontendLaunchFileError
from zbot.launch.source import load_launch_file as get_launch_description_from_frontend_launch_file

__all__ = ["InvalidFrontendLaunchFileError", "get_launch_description_from_frontend_launch_file"]
