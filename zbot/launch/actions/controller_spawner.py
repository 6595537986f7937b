"""Launch descriptions that spawn controllers: `controller_manager.launch_utils` of ROS 2."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.launch.actions.declare_argument import DeclareLaunchArgument
from zbot.launch.actions.node import Node
from zbot.launch.description import LaunchDescription
from zbot.launch.errors import EntityTypeError
from zbot.launch.substitutions.python_expression import PythonExpression
from zbot.launch.substitutions.value import LaunchConfiguration

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from zbot.launch.substitution import SomeSubstitutionsType

    Words = Sequence[SomeSubstitutionsType]

#: For each key of `generate_spawner_launch_description`: its type, and the option of the spawner.
_OPTIONS: dict[str, tuple[type, str]] = {
    "load_only": (bool, "--load-only"),
    "inactive": (bool, "--inactive"),
    "ros_args": (str, "--controller-ros-args"),
}


def generate_controllers_spawner_launch_description(
    controller_names: Words,
    controller_params_files: Words | None = None,
    extra_spawner_args: Words = (),
) -> LaunchDescription:
    """Return a description that loads, configures and activates controllers.

    It declares the arguments `controller_manager_name` and `unload_on_kill`.

    Args:
        controller_names: The controllers.
        controller_params_files: Files with parameters of the controllers.
        extra_spawner_args: More words for the spawner.
    """
    arguments = [
        DeclareLaunchArgument(
            "controller_manager_name",
            default_value="controller_manager",
            description="Node of the controller manager",
        ),
        DeclareLaunchArgument(
            "unload_on_kill",
            default_value="false",
            description="Whether the spawner goes on, and unloads the controllers when it ends",
        ),
    ]
    unload = LaunchConfiguration("unload_on_kill")
    words = [
        *controller_names,
        "--controller-manager",
        LaunchConfiguration("controller_manager_name"),
        *_file_words(controller_params_files or ()),
        PythonExpression(["'--unload-on-kill' if '", unload, "' == 'true' else ''"]),
        *extra_spawner_args,
    ]
    return LaunchDescription([*arguments, _spawner(words)])


def generate_controllers_spawner_launch_description_from_dict(
    controller_info_dict: Mapping[str, Any], extra_spawner_args: Words = ()
) -> LaunchDescription:
    """Return a description that spawns controllers with the file, the files or None of each.

    Raises:
        EntityTypeError: The value is not a dictionary, or a file is neither a path nor a list.
    """
    info = _checked("controller_info_dict", controller_info_dict, dict)
    files = [path for value in info.values() for path in _files(value)]
    return generate_controllers_spawner_launch_description(list(info), files, extra_spawner_args)


def generate_load_controller_launch_description(
    controller_name: SomeSubstitutionsType,
    controller_params_file: SomeSubstitutionsType | None = None,
    extra_spawner_args: Words = (),
    *,
    controller_type: SomeSubstitutionsType | None = None,
) -> LaunchDescription:
    """Return a description that spawns one controller.

    Args:
        controller_name: The controller.
        controller_params_file: A file with parameters of the controller.
        extra_spawner_args: More words for the spawner.
        controller_type: The type of the controller, as in ROS 2 Humble.
    """
    files = None if controller_params_file is None else [controller_params_file]
    kind = () if controller_type is None else ("--controller-type", controller_type)
    return generate_controllers_spawner_launch_description(
        [controller_name], files, [*kind, *extra_spawner_args]
    )


def generate_spawner_launch_description(
    controller_info_dict: Mapping[str, Mapping[str, Any]], extra_spawner_args: Words = ()
) -> LaunchDescription:
    """Return a description that spawns controllers with options of their own.

    Args:
        controller_info_dict: For each controller, a dictionary with `param_file` (a path, a list of
            paths or None), `load_only` and `inactive` (truth values) and `ros_args` (a text).
        extra_spawner_args: More words for the spawner.

    Raises:
        EntityTypeError: A value has another type.
    """
    words: list[SomeSubstitutionsType] = []
    for name, options in _checked("controller_info_dict", controller_info_dict, dict).items():
        words += ["--controller", name, *_file_words(_files(options.get("param_file")))]
        for key, (kind, word) in _OPTIONS.items():
            value = _checked(key, options.get(key, kind()), kind)
            words += [] if not value else [word] if kind is bool else [word, value]
    return LaunchDescription([_spawner([*words, *extra_spawner_args])])


def _checked(where: str, value: Any, kind: type) -> Any:
    if not isinstance(value, kind):
        raise EntityTypeError(where, f"a {kind.__name__}", value)
    return value


def _files(value: Any) -> list[SomeSubstitutionsType]:
    if value is None or isinstance(value, list):
        return value or []
    return [_checked("the parameter file of a controller", value, str)]


def _file_words(paths: Words) -> list[SomeSubstitutionsType]:
    return [word for path in paths if path for word in ("--param-file", path)]


def _spawner(words: Words) -> Node:
    return Node(
        package="controller_manager", executable="spawner", arguments=words, output="screen"
    )
