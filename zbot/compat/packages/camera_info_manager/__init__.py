"""ROS 2's `camera_info_manager` for Python: calibrations of cameras."""

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
