from __future__ import annotations

from typing import Any

import pytest

from zbot.launch import LaunchContext, LaunchDescription
from zbot.launch.actions import DeclareLaunchArgument, Node
from zbot.launch.actions.controller_spawner import (
    generate_controllers_spawner_launch_description,
    generate_controllers_spawner_launch_description_from_dict,
    generate_load_controller_launch_description,
    generate_spawner_launch_description,
)
from zbot.launch.errors import EntityTypeError
from zbot.launch.substitution import perform
from zbot.launch.substitutions import LaunchConfiguration


def words(description: LaunchDescription, **configurations: str) -> str:
    """Return the words for the spawner, as the launch file of a user gives them."""
    context = LaunchContext()
    context.launch_configurations["files"] = "/robot"
    for entity in description.entities[:-1]:
        assert isinstance(entity, DeclareLaunchArgument)
        entity.execute(context)
    context.launch_configurations.update(configurations)
    spawner = description.entities[-1]
    assert isinstance(spawner, Node)
    assert perform(context, spawner.executable) == "spawner"
    return " ".join(filter(None, (perform(context, argument) for argument in spawner.arguments)))


FILE: list[Any] = [LaunchConfiguration("files"), "/arm.yaml"]


@pytest.mark.parametrize(
    ("description", "expected"),
    [
        (
            generate_controllers_spawner_launch_description(["a", "b"]),
            "a b --controller-manager controller_manager",
        ),
        (
            generate_controllers_spawner_launch_description(["a"], [FILE], ["--load-only"]),
            "a --controller-manager controller_manager --param-file /robot/arm.yaml --load-only",
        ),
        (
            generate_controllers_spawner_launch_description_from_dict(
                {"a": "x.yaml", "b": ["y.yaml", "z.yaml"], "c": None}
            ),
            (
                "a b c --controller-manager controller_manager"
                " --param-file x.yaml --param-file y.yaml --param-file z.yaml"
            ),
        ),
        (
            generate_load_controller_launch_description("a", FILE),
            "a --controller-manager controller_manager --param-file /robot/arm.yaml",
        ),
        (
            generate_load_controller_launch_description("a", controller_type="b/C"),
            "a --controller-manager controller_manager --controller-type b/C",
        ),
        (
            generate_spawner_launch_description(
                {
                    "a": {"param_file": ["x.yaml"], "inactive": True, "load_only": False},
                    "b": {"ros_args": "-r x:=y"},
                },
                ["--switch-asap"],
            ),
            (
                "--controller a --param-file x.yaml --inactive"
                " --controller b --controller-ros-args -r x:=y --switch-asap"
            ),
        ),
    ],
)
def test_controllers_are_words_of_the_spawner(
    description: LaunchDescription, expected: str
) -> None:
    assert words(description) == expected


def test_arguments_of_the_launch_choose_manager_and_unloading() -> None:
    description = generate_load_controller_launch_description("a")
    found = words(description, controller_manager_name="/r1/manager", unload_on_kill="true")
    assert found == "a --controller-manager /r1/manager --unload-on-kill"


@pytest.mark.parametrize(
    ("function", "value"),
    [
        (generate_controllers_spawner_launch_description_from_dict, ["a"]),
        (generate_controllers_spawner_launch_description_from_dict, {"a": 3}),
        (generate_spawner_launch_description, {"a": {"inactive": "true"}}),
    ],
)
def test_values_of_another_type_are_refused(function: Any, value: Any) -> None:
    with pytest.raises(EntityTypeError, match="must be a"):
        function(value)
