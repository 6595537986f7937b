"""The same names, as some programs import them."""

from zbot.tf2.cloud_transform import do_transform_cloud as do_transform_cloud
from zbot.tf2.cloud_transform import transform_points as transform_points
