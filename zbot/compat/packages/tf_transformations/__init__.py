"""ROS 2's `tf_transformations`: rotations and matrices; needs numpy."""

from zbot.tf2.transformations import compose_matrix as compose_matrix
from zbot.tf2.transformations import concatenate_matrices as concatenate_matrices
from zbot.tf2.transformations import decompose_matrix as decompose_matrix
from zbot.tf2.transformations import euler_from_matrix as euler_from_matrix
from zbot.tf2.transformations import euler_from_quaternion as euler_from_quaternion
from zbot.tf2.transformations import euler_matrix as euler_matrix
from zbot.tf2.transformations import identity_matrix as identity_matrix
from zbot.tf2.transformations import inverse_matrix as inverse_matrix
from zbot.tf2.transformations import is_same_transform as is_same_transform
from zbot.tf2.transformations import quaternion_about_axis as quaternion_about_axis
from zbot.tf2.transformations import quaternion_conjugate as quaternion_conjugate
from zbot.tf2.transformations import quaternion_from_euler as quaternion_from_euler
from zbot.tf2.transformations import quaternion_from_matrix as quaternion_from_matrix
from zbot.tf2.transformations import quaternion_inverse as quaternion_inverse
from zbot.tf2.transformations import quaternion_matrix as quaternion_matrix
from zbot.tf2.transformations import quaternion_multiply as quaternion_multiply
from zbot.tf2.transformations import quaternion_slerp as quaternion_slerp
from zbot.tf2.transformations import random_quaternion as random_quaternion
from zbot.tf2.transformations import random_rotation_matrix as random_rotation_matrix
from zbot.tf2.transformations import rotation_matrix as rotation_matrix
from zbot.tf2.transformations import scale_matrix as scale_matrix
from zbot.tf2.transformations import translation_from_matrix as translation_from_matrix
from zbot.tf2.transformations import translation_matrix as translation_matrix
from zbot.tf2.transformations import unit_vector as unit_vector
from zbot.tf2.transformations import vector_norm as vector_norm
