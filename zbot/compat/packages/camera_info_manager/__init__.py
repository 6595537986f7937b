# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's `camera_info_manager` for Python: calibrations of cameras."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names
from zbot.libraries.camera_calibration import (
    CameraInfoError,
    loadCalibrationFile,
    saveCalibrationFile,
)
from zbot.libraries.camera_info_manager import (
    CameraInfoManager,
    CameraInfoMissingError,
    URL_empty,
    URL_file,
    URL_invalid,
    URL_package,
    default_camera_info_url,
    genCameraName,
    getPackageFileName,
    parseURL,
    resolveURL,
    saveCalibration,
)

__all__ = [
    "CameraInfoError",
    "CameraInfoManager",
    "CameraInfoMissingError",
    "URL_empty",
    "URL_file",
    "URL_invalid",
    "URL_package",
    "default_camera_info_url",
    "genCameraName",
    "getPackageFileName",
    "loadCalibrationFile",
    "parseURL",
    "resolveURL",
    "saveCalibration",
    "saveCalibrationFile",
]

if TYPE_CHECKING:
    from . import camera_info_manager as camera_info_manager
else:
    __getattr__ = lazy_names(
        __name__,
        {
        },
        submodules=(
            "camera_info_manager",
        ),
    )[0]
