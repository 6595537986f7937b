"""What packages register."""

from zbot.package.ament_index import InvalidResourceNameError as InvalidResourceNameError
from zbot.package.ament_index import InvalidResourceTypeNameError as InvalidResourceTypeNameError
from zbot.package.ament_index import get_resource as get_resource
from zbot.package.ament_index import get_resource_types as get_resource_types
from zbot.package.ament_index import get_resources as get_resources
from zbot.package.ament_index import has_resource as has_resource
