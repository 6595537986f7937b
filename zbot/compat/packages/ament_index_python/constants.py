# Written by python -m zbot.compat.generator; do not edit.
"""Names of files and variables."""

from zbot.package.ament_index import AMENT_PREFIX_PATH_ENV_VAR, RESOURCE_INDEX_SUBFOLDER

__all__ = [
    "AMENT_PREFIX_PATH_ENV_VAR",
    "RESOURCE_INDEX_SUBFOLDER",
]
