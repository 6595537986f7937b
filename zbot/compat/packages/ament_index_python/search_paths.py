"""Folders that packages are installed to."""

from zbot.package.ament_index import get_search_paths
