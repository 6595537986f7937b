"""Where packages are installed to."""

from zbot.package.ament_index import get_search_paths as get_search_paths
