"""ROS 2's `tf2_sensor_msgs`: point clouds in other frames."""

from zbot.tf2.cloud_transform import do_transform_cloud, transform_points
