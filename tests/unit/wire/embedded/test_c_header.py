"""Tests of the C headers: gcc compiles them, and their bytes are those of zbot."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tests.unit.wire.embedded.c_program import differences
from zbot.interfaces import interface_names
from zbot.wire.embedded.included_types import interfaces_of, messages_of

if TYPE_CHECKING:
    from pathlib import Path

_PACKAGES = ("test_msgs", "std_msgs", "geometry_msgs", "sensor_msgs", "nav_msgs", "std_srvs")


def test_a_hundred_types_have_the_bytes_of_zbot_in_both_directions(tmp_path: Path) -> None:
    names = [name for package in _PACKAGES for name in interface_names(package)]
    count = len(messages_of(interfaces_of(names)))
    assert count > 100
    assert differences(tmp_path, names) == f"{count} types\n"
