"""Names of files and variables."""

from zbot.package.ament_index import AMENT_PREFIX_PATH_ENV_VAR as AMENT_PREFIX_PATH_ENV_VAR
from zbot.package.ament_index import RESOURCE_INDEX_SUBFOLDER as RESOURCE_INDEX_SUBFOLDER
