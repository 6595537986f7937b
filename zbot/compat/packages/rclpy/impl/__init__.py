"""What rclpy is made of, as far as programs use it."""

from zbot.compat.submodules import submodules

__getattr__ = submodules(__name__, "implementation_singleton", "logging_severity", "rcutils_logger")
