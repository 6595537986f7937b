"""Tests of the environment of a launch."""

from __future__ import annotations

import os

from zbot.launch import LaunchContext
from zbot.launch.actions import (
    PopEnvironment,
    PushEnvironment,
    ResetEnvironment,
    SetEnvironmentVariable,
    UnsetEnvironmentVariable,
)


def test_the_end_of_a_launch_takes_back_only_its_own_changes() -> None:
    os.environ.update({"KEPT": "a", "CHANGED": "a", "REMOVED": "a"})
    context = LaunchContext()
    SetEnvironmentVariable("CHANGED", "b").visit(context)
    SetEnvironmentVariable("CHANGED", "c").visit(context)
    SetEnvironmentVariable("NEW", "b").visit(context)
    UnsetEnvironmentVariable("REMOVED").visit(context)
    os.environ["KEPT"] = "b"
    assert (os.environ["CHANGED"], os.environ["NEW"]) == ("c", "b")
    assert "REMOVED" not in os.environ
    context.close()
    assert (os.environ["CHANGED"], os.environ["REMOVED"], os.environ["KEPT"]) == ("a", "a", "b")
    assert "NEW" not in os.environ
    os.environ["CHANGED"] = "d"
    context.close()
    assert os.environ["CHANGED"] == "d"


def test_a_scope_and_a_reset_restore_the_environment() -> None:
    context = LaunchContext()
    SetEnvironmentVariable("COLOUR", "red").visit(context)
    PushEnvironment().visit(context)
    SetEnvironmentVariable("COLOUR", "blue").visit(context)
    PopEnvironment().visit(context)
    assert os.environ["COLOUR"] == "red"
    ResetEnvironment().visit(context)
    assert "COLOUR" not in os.environ
