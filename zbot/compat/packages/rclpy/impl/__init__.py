"""Internal modules of rclpy that programs use."""

from zbot.compat.submodules import submodules

__getattr__ = submodules(__name__, "implementation_singleton", "logging_severity", "rcutils_logger")
