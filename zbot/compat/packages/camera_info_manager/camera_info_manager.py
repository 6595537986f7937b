# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for all names of `camera_info_manager`."""

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
