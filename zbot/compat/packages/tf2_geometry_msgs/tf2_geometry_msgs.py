"""The same names, as some programs import them."""

from zbot.tf2.conversion import do_transform_point as do_transform_point
from zbot.tf2.conversion import do_transform_polygon_stamped as do_transform_polygon_stamped
from zbot.tf2.conversion import do_transform_pose as do_transform_pose
from zbot.tf2.conversion import do_transform_pose_stamped as do_transform_pose_stamped
from zbot.tf2.conversion import (
    do_transform_pose_with_covariance_stamped as do_transform_pose_with_covariance_stamped,
)
from zbot.tf2.conversion import do_transform_vector3 as do_transform_vector3
from zbot.tf2.conversion import do_transform_wrench as do_transform_wrench
from zbot.tf2.conversion import transform_covariance as transform_covariance

from geometry_msgs.msg import PointStamped as PointStamped
from geometry_msgs.msg import PoseStamped as PoseStamped
from geometry_msgs.msg import PoseWithCovarianceStamped as PoseWithCovarianceStamped
from geometry_msgs.msg import Vector3Stamped as Vector3Stamped
