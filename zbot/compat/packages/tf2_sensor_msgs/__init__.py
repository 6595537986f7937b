"""ROS 2's `tf2_sensor_msgs`: point clouds in other frames."""

from zbot.tf2.cloud_transform import do_transform_cloud as do_transform_cloud
from zbot.tf2.cloud_transform import transform_points as transform_points
