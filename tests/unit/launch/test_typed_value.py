from __future__ import annotations

from typing import Any, List  # noqa: UP035 - as launch files write it

import pytest

from zbot.launch.context import LaunchContext
from zbot.launch.errors import EntityTypeError
from zbot.launch.logger import launch_config
from zbot.launch.substitutions.value import LaunchConfiguration
from zbot.launch.typed_value import normalize_typed_substitution, perform_typed_substitution


@pytest.mark.parametrize(
    ("text", "data_type", "expected"),
    [
        ("true", bool, True),
        ("5", int, 5),
        ("5", float, 5.0),
        ("5", str, "5"),
        ("[1, 2]", List[int], [1, 2]),  # noqa: UP006 - as above
        ("[a, b]", None, ["a", "b"]),
        ("hello", None, "hello"),
    ],
)
def test_a_configuration_becomes_a_value(text: str, data_type: Any, expected: Any) -> None:
    context = LaunchContext()
    context.launch_configurations["speed"] = text
    value = normalize_typed_substitution(LaunchConfiguration("speed"), data_type)
    found = perform_typed_substitution(context, value, data_type)
    assert found == expected
    assert type(found) is type(expected)


def test_values_stay_and_lists_are_gone_through() -> None:
    context = LaunchContext()
    context.launch_configurations["speed"] = "5"
    assert perform_typed_substitution(context, 3, int) == 3
    mixed = [3, LaunchConfiguration("speed")]
    assert perform_typed_substitution(context, mixed, list[int]) == [3, 5]


@pytest.mark.parametrize(("text", "data_type"), [("fast", int), ("1.5", int), ("[a]", list[int])])
def test_another_type_is_refused(text: str, data_type: Any) -> None:
    value = normalize_typed_substitution(text)
    with pytest.raises(EntityTypeError):
        perform_typed_substitution(LaunchContext(), value, data_type)


def test_the_folder_of_logs_can_be_set(
    monkeypatch: pytest.MonkeyPatch, tmp_path_factory: pytest.TempPathFactory
) -> None:
    monkeypatch.setenv("ZBOT_LOG_DIR", "elsewhere")
    folder = str(tmp_path_factory.getbasetemp())
    launch_config.log_dir = folder
    assert launch_config.log_dir == folder
