"""Show a robot description, with sliders. The arguments are those of the genuine urdf_tutorial."""

from pathlib import Path

from ament_index_python.packages import get_package_share_path
from launch import LaunchContext, LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription, OpaqueFunction
from launch.substitutions import LaunchConfiguration

PACKAGE = Path(__file__).parents[1]
DISPLAY = str(get_package_share_path("urdf_launch") / "launch" / "display.launch.py")


def display(context: LaunchContext) -> list[IncludeLaunchDescription]:
    """Return the description, the joints and the viewer.

    The path of the model starts in the current folder, as in ROS 2 Humble, or in the package.
    """
    model = LaunchConfiguration("model").perform(context)
    inside = PACKAGE / model
    path = inside if inside.is_file() and not Path(model).is_file() else Path(model).absolute()
    given = {
        "urdf_package": "urdf_tutorial",
        "urdf_package_path": str(path),
        "rviz_config": LaunchConfiguration("rvizconfig"),
        "jsp_gui": LaunchConfiguration("gui"),
    }
    return [IncludeLaunchDescription(DISPLAY, launch_arguments=given.items())]


def generate_launch_description() -> LaunchDescription:
    """Return the arguments, and what shows the model."""
    view = str(PACKAGE / "rviz" / "urdf.rviz")
    return LaunchDescription(
        [
            DeclareLaunchArgument(
                "model",
                default_value="urdf/01-myfirst.urdf",
                description="The file of the description, in URDF or xacro",
            ),
            DeclareLaunchArgument("gui", default_value="true", choices=["true", "false"]),
            DeclareLaunchArgument("rvizconfig", default_value=view),
            OpaqueFunction(function=display),
        ]
    )
