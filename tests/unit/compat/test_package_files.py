"""Tests of the names of ros2launch and ros2pkg."""

from __future__ import annotations

import pytest

from zbot.compat.package_files import get_package_names, get_prefix_path
from zbot.compat.package_files import get_share_file_path_from_package as path_of
from zbot.package import package_prefix, package_share


def test_files_of_packages_are_found_by_name() -> None:
    found = path_of(package_name="std_msgs", file_name="String.msg")
    assert found == str(package_share("std_msgs") / "msg" / "String.msg")
    with pytest.raises(FileNotFoundError, match="the package 'std_msgs' has no file"):
        path_of(package_name="std_msgs", file_name="Text.msg")


def test_packages_have_names_and_prefixes() -> None:
    assert "std_msgs" in get_package_names()
    assert get_prefix_path("std_msgs") == str(package_prefix("std_msgs"))
    assert get_prefix_path("no_such_package") is None
