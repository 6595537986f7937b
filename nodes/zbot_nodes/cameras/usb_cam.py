"""Publish the images of a webcam, as ROS 2's usb_cam.

Run:        zbot run usb_cam usb_cam_node_exe
Publishes:  image_raw (sensor_msgs/Image), camera_info (sensor_msgs/CameraInfo)
Services:   set_capture (std_srvs/SetBool), set_camera_info (sensor_msgs/SetCameraInfo)
Parameters: video_device ("/dev/video0": also a video file or a folder of pictures),
            framerate (30.0), image_width (640), image_height (480), frame_id ("default_cam"),
            camera_name ("default_cam"), camera_info_url (""), pixel_format ("yuyv2rgb"; mono8)
Needs:      pip install "zbot[camera]"
"""

from __future__ import annotations

from typing import Any

from zbot_nodes.cameras.camera_driver import CameraDriver
from zbot_nodes.startup.program import run_node

from std_srvs.srv import SetBool

_MOST_HZ = 1000.0
#: Parameters of ROS 2's node that change nothing here.
_IGNORED = {
    **dict.fromkeys(("brightness", "contrast", "saturation", "sharpness", "gain", "focus"), -1),
    "io_method": "mmap",
    "av_device_format": "YUV422P",
    "auto_white_balance": True,
    "white_balance": 4000,
    "autoexposure": True,
    "exposure": 100,
    "autofocus": False,
}


class UsbCam(CameraDriver):
    """Publishes images, while the service `set_capture` has not switched them off.

    Args:
        options: The options of `zbot.Node`.
    """

    def __init__(self, **options: Any) -> None:
        super().__init__("usb_cam", **options)
        for name, default in _IGNORED.items():
            self.declare_parameter(name, default)
        device = str(self.declare_parameter("video_device", "/dev/video0").value)
        camera = str(self.declare_parameter("camera_name", "default_cam").value)
        self.frame_id = str(self.declare_parameter("frame_id", "default_cam").value)
        width = self.declare_parameter("image_width", 640).value
        height = self.declare_parameter("image_height", 480).value
        pixels = str(self.declare_parameter("pixel_format", "yuyv2rgb").value)
        self.encoding = "mono8" if pixels.startswith(("mono", "grey")) else "rgb8"
        rate_hz = self.number("framerate", 30.0, _MOST_HZ)
        self.begin(device, self.size(width, height), rate_hz, camera)
        self.create_service(SetBool, "set_capture", self.set_capture)

    def set_capture(self, request: SetBool.Request, response: SetBool.Response) -> Any:
        """Switch the images on or off."""
        self.is_capturing = request.data
        response.success = True
        response.message = "Start Capturing" if request.data else "Stop Capturing"
        return response


def main() -> None:
    """Run until Ctrl-C."""
    run_node(UsbCam)


if __name__ == "__main__":
    main()
