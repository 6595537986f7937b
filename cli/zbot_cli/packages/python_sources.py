"""Sources of Python packages: names on PyPI, or repositories of ROS 2's own packages."""

from __future__ import annotations

from zbot.errors.installation import pip_install

#: Modules whose package has another name on PyPI.
_PYPI = {
    "Crypto": "pycryptodome", "OpenSSL": "pyopenssl", "PIL": "pillow", "PyQt5": "pyqt5",
    "PyQt6": "pyqt6", "PySide2": "pyside2", "PySide6": "pyside6", "RPi": "RPi.GPIO",
    "Xlib": "python-xlib", "adafruit_motor": "adafruit-circuitpython-motor", "attr": "attrs",
    "board": "adafruit-blinka", "bs4": "beautifulsoup4", "busio": "adafruit-blinka",
    "can": "python-can", "catkin_pkg": "catkin-pkg", "cv2": "opencv-python",
    "dateutil": "python-dateutil", "digitalio": "adafruit-blinka", "dotenv": "python-dotenv",
    "dynamixel_sdk": "dynamixel-sdk", "fitz": "pymupdf", "gi": "pygobject", "git": "gitpython",
    "google": "protobuf", "grpc": "grpcio", "jwt": "pyjwt", "magic": "python-magic",
    "nacl": "pynacl", "osrf_pycommon": "osrf-pycommon", "paho": "paho-mqtt",
    "pkg_resources": "setuptools", "pyaudio": "PyAudio", "ruamel": "ruamel.yaml",
    "serial": "pyserial", "skimage": "scikit-image", "sklearn": "scikit-learn", "smbus": "smbus2",
    "socketio": "python-socketio", "speech_recognition": "SpeechRecognition", "usb": "pyusb",
    "websocket": "websocket-client", "wx": "wxpython", "yaml": "pyyaml", "zmq": "pyzmq",
}  # fmt: skip
#: Python packages of ROS 2 that are not on PyPI, with their repositories on GitHub.
_REPOSITORIES = {
    "camera_info_manager_py": "ros-perception/image_pipeline",
    "joint_state_publisher": "ros/joint_state_publisher",
    "launch_pal": "pal-robotics/launch_pal",
    "launch_param_builder": "PickNikRobotics/launch_param_builder",
    "moveit_configs_utils": "moveit/moveit2",
    "py_trees_ros": "splintered-reality/py_trees_ros",
    "python_qt_binding": "ros-visualization/python_qt_binding",
    "rclpy_message_converter": "DFKI-NI/rospy_message_converter",
    "resource_retriever": "ros/resource_retriever",
    "ros2_numpy": "Box-Robotics/ros2_numpy",
    "rosapi": "RobotWebTools/rosbridge_suite",
    "rosbridge_library": "RobotWebTools/rosbridge_suite",
    "rqt_gui_py": "ros-visualization/rqt",
    "smach": "ros/executive_smach",
    "srdfdom": "moveit/srdfdom/tree/ros2",
    "teleop_twist_keyboard": "ros2/teleop_twist_keyboard",
    "turtlebot4_navigation": "turtlebot/turtlebot4",
    "urdf_parser_py": "ros/urdf_parser_py/tree/ros2",
    "yasmin": "uleroboticsgroup/yasmin",
    "yasmin_ros": "uleroboticsgroup/yasmin",
}
#: Modules of ROS 1. Packages of PyPI with these names are not the genuine ones.
_ROS1 = {"actionlib", "roslaunch", "roslib", "rospy", "tf"}
_KEY = "python3-"
#: Modules of rosdep's keys (without `python3-`) that `_PYPI` does not contain.
_MODULES = {
    "libgpiod": "gpiod", "opencv": "cv2", "pil": "PIL", "pil-imagetk": "PIL", "smbus": "smbus",
    "tk": "tkinter", "usb": "usb",
}  # fmt: skip
#: Keys of rosdep for tools that a program does not import.
_TOOLS = {"dev", "pip", "pytest", "setuptools", "venv"}


def name_on_pypi(module: str) -> str:
    """Return the name on PyPI of the package with a top-level module, or an empty string.

    An empty string means that the module is part of ROS 2. If a module is in no table, its name is
    assumed to be also the name on PyPI.
    """
    return "" if module in _REPOSITORIES else _PYPI.get(module, module)


def how_to_get(module: str) -> str:
    """Return the instruction with which the user gets the package of a top-level module."""
    if module == "tkinter":
        return "install your system's package python3-tk"  # it is a part of Python, not of PyPI
    if module in _ROS1:
        return f"{module} is a part of ROS 1: use its successor in ROS 2"
    name = name_on_pypi(module)
    if name:
        return pip_install(name)
    return f"download https://github.com/{_REPOSITORIES[module]} into src"


def module_of_key(key: str) -> str:
    """Return the module that a key of rosdep such as `python3-serial` means, or an empty string."""
    if key == "xacro":  # ROS 2 and PyPI have a package with this name
        return key
    if not key.startswith(_KEY):
        return ""
    name = key.removeprefix(_KEY).removesuffix("-pip")
    if name in _TOOLS:
        return ""
    modules = {package.lower(): module for module, package in _PYPI.items()}
    return _MODULES.get(name) or modules.get(name.lower()) or name.replace("-", "_")
