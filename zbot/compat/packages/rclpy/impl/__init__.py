# Written by python -m zbot.compat.generator; do not edit.
"""Internal modules of rclpy that programs use."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names

if TYPE_CHECKING:
    from . import implementation_singleton as implementation_singleton
    from . import logging_severity as logging_severity
    from . import rcutils_logger as rcutils_logger
else:
    __getattr__ = lazy_names(
        __name__,
        {
        },
        submodules=(
            "implementation_singleton",
            "logging_severity",
            "rcutils_logger",
        ),
    )[0]
