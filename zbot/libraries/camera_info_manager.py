"""Calibration of a driver's camera: the Python package `camera_info_manager` of ROS 2.

A URL says where a calibration is: `file:///home/me/camera.yaml` or
`package://my_robot/config/camera.yaml`. In a URL, `${NAME}` is the name of the camera, and
`${ROS_HOME}` is the folder `.ros`. The empty URL means `default_camera_info_url`.
"""

from __future__ import annotations

import os
import re
from pathlib import Path
from typing import TYPE_CHECKING

from zbot.libraries.camera_calibration import (
    CameraInfoError,
    loadCalibrationFile,
    saveCalibrationFile,
)
from zbot.log.logger import get_logger
from zbot.package.ament_index import get_package_share_directory
from zbot.package.errors import PackageNameError, PackageNotFoundError

from sensor_msgs.srv import SetCameraInfo

if TYPE_CHECKING:
    from zbot.node.node import Node

    from sensor_msgs.msg import CameraInfo

default_camera_info_url = "file://${ROS_HOME}/camera_info/${NAME}.yaml"
#: Kinds of URLs, which `parseURL` returns.
URL_empty, URL_file, URL_package, URL_invalid = range(4)
_FILE, _PACKAGE = "file://", "package://"
_DRIVE = re.compile(r"/[A-Za-z]:")  # file:///C:/camera.yaml


class CameraInfoMissingError(CameraInfoError):
    """A calibration is used before `loadCameraInfo()`, or its package does not exist."""


class CameraInfoManager:
    """Calibration of one camera, which other programs can set by the service `set_camera_info`.

    Call `loadCameraInfo()` before the calibration is used, and after the name or the URL changed.

    Args:
        node: The node of the driver. It is spun, so that the service works.
        cname: Name of the camera: letters, digits and `_`.
        url: Where the calibration is.
        namespace: Namespace of the service, for a node with several cameras.
    """

    def __init__(
        self, node: Node, cname: str = "camera", url: str = "", namespace: str = ""
    ) -> None:
        self.node, self.cname, self.url = node, cname, url
        self.camera_info: CameraInfo | None = None
        name = f"{namespace}/set_camera_info" if namespace else "set_camera_info"
        self.svc = node.create_service(SetCameraInfo, name, self.setCameraInfo)

    def __str__(self) -> str:
        """Return the name of the camera and the URL."""
        return f"[{self.cname}]{self.url}"

    def getCameraInfo(self) -> CameraInfo:
        """Return the calibration.

        Raises:
            CameraInfoMissingError: `loadCameraInfo()` was not called.
        """
        if self.camera_info is None:
            raise CameraInfoMissingError("the calibration is missing: call loadCameraInfo() first")
        return self.camera_info

    def isCalibrated(self) -> bool:
        """Return whether there is a calibration that is not empty.

        Raises:
            CameraInfoMissingError: `loadCameraInfo()` was not called.
        """
        return bool(self.getCameraInfo().k[0] != 0.0)

    def getCameraName(self) -> str:
        """Return the name of the camera."""
        return self.cname

    def getURL(self) -> str:
        """Return the URL, with its variables."""
        return self.url

    def loadCameraInfo(self) -> None:
        """Read the calibration. It is empty if the file does not exist.

        Raises:
            OSError: The file exists, but cannot be read.
            CameraInfoError: The file is not a calibration.
            CameraInfoMissingError: There is no package with the name in the URL.
        """
        url = resolveURL(self.url or default_camera_info_url, self.cname)
        self.node.get_logger().info(f"camera calibration URL: {url}")
        if parseURL(url) == URL_invalid:
            raise CameraInfoError(
                f"invalid URL of a calibration '{url}': write file:///PATH or package://PACKAGE/PATH"
            )
        filename = _path(url)
        if not filename:
            raise CameraInfoMissingError(f"there is no package for the calibration '{url}'")
        self.camera_info = loadCalibrationFile(filename, self.cname)

    def setCameraInfo(
        self, req: SetCameraInfo.Request, rsp: SetCameraInfo.Response
    ) -> SetCameraInfo.Response:
        """Use the calibration of a request, and save it."""
        self.camera_info = req.camera_info
        rsp.success = saveCalibration(req.camera_info, self.url, self.cname)
        if not rsp.success:
            rsp.status_message = "Error storing camera calibration."
        return rsp

    def setCameraName(self, cname: str) -> bool:
        """Change the name. Return False if it is empty or has a character that is not allowed."""
        if not cname or cname != genCameraName(cname):
            return False
        if cname != self.cname:
            self.cname, self.camera_info = cname, None
        return True

    def setURL(self, url: str) -> bool:
        """Change the URL. Return False if it is not valid."""
        if parseURL(resolveURL(url, self.cname)) == URL_invalid:
            return False
        if url != self.url:
            self.url, self.camera_info = url, None
        return True


def genCameraName(from_string: str) -> str:
    """Return a valid name of a camera: other characters than letters and digits become `_`."""
    return "".join(character if character.isalnum() else "_" for character in from_string) or "_"


def parseURL(url: str) -> int:
    """Return the kind of a URL without variables, e.g. `URL_file`."""
    if not url:
        return URL_empty
    if url.lower().startswith(_FILE):
        return URL_file
    if url.lower().startswith(_PACKAGE) and url[len(_PACKAGE) :].partition("/")[2]:
        return URL_package
    return URL_invalid


def resolveURL(url: str, cname: str) -> str:
    """Return a URL with the values of `${NAME}` and `${ROS_HOME}`. Other variables stay."""
    values = {"NAME": cname, "ROS_HOME": os.environ.get("ROS_HOME") or str(Path.home() / ".ros")}

    def value(match: re.Match[str]) -> str:
        if match[1] not in values:
            text = f"the URL '{url}' has the unknown variable {match[0]}"
            get_logger("camera_info_manager").warning(text)
        return values.get(match[1], match[0])

    return re.sub(r"\$\{(\w*)\}", value, url)


def getPackageFileName(url: str) -> str:
    """Return the path of a `package:` URL. It is empty if there is no such package."""
    package, _, rest = url[len(_PACKAGE) :].partition("/")
    try:
        return f"{get_package_share_directory(package)}/{rest}"
    except (PackageNotFoundError, PackageNameError):
        get_logger("camera_info_manager").warning(f"unknown package: {package} (ignored)")
        return ""


def _path(url: str) -> str:
    """Return the path of a valid URL. It is empty if there is no package with the name."""
    if parseURL(url) == URL_package:
        return getPackageFileName(url)
    path = url[len(_FILE) :]
    return path[1:] if _DRIVE.match(path) else path


def saveCalibration(new_info: CameraInfo, url: str, cname: str) -> bool:
    """Save a calibration. If the URL cannot be used, `default_camera_info_url` is used.

    Returns:
        Whether the calibration was saved. The log has the reason if not.
    """
    resolved = resolveURL(url or default_camera_info_url, cname)
    filename = "" if parseURL(resolved) == URL_invalid else _path(resolved)
    if not filename:
        get_logger("camera_info_manager").error(f"Invalid camera calibration URL: {resolved}")
        filename = _path(resolveURL(default_camera_info_url, cname))
    get_logger("camera_info_manager").info(f"writing calibration data to {filename}")
    return saveCalibrationFile(new_info, filename, cname)
