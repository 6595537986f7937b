"""The same names under a second module's name, which some programs import."""

from zbot.tf2.cloud_transform import do_transform_cloud, transform_points
