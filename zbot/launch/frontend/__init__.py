"""Loaders of launch files in XML and YAML."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.launch.frontend import ros_tags, tags, xml_file, yaml_file
from zbot.launch.frontend.parser import Parser

if TYPE_CHECKING:
    from pathlib import Path

    from zbot.launch.description import LaunchDescription

__all__ = ["load_file", "ros_tags", "tags", "yaml_file"]

_LOADERS = {"xml": xml_file.load, "yaml": yaml_file.load}


def load_file(path: Path, kind: str) -> LaunchDescription:
    """Return the launch description of a launch file.

    Args:
        path: The file.
        kind: `xml` or `yaml`.

    Raises:
        LaunchFileError: The file is invalid.
    """
    return Parser().parse_description(_LOADERS[kind](path))
