"""Point clouds as numpy arrays and back."""

from zbot.libraries.point_cloud import create_cloud as create_cloud
from zbot.libraries.point_cloud import create_cloud_xyz32 as create_cloud_xyz32
from zbot.libraries.point_cloud import dtype_from_fields as dtype_from_fields
from zbot.libraries.point_cloud import read_points as read_points
from zbot.libraries.point_cloud import read_points_list as read_points_list
from zbot.libraries.point_cloud import read_points_numpy as read_points_numpy

from sensor_msgs.msg import PointCloud2 as PointCloud2
from sensor_msgs.msg import PointField as PointField
