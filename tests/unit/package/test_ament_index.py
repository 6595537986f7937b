"""Tests of `ament_index_python` with installed packages and packages of a workspace."""

from __future__ import annotations

import importlib
from pathlib import Path
from typing import Any

import pytest

import zbot.compat  # noqa: F401 - makes it importable
from zbot.package import ament_index
from zbot.package.ament_index import (
    InvalidResourceNameError,
    InvalidResourceTypeNameError,
    ResourceNotFoundError,
)

#: Names of ROS 2's ament_index_python, by module.
NAMES = {
    "": [
        "InvalidResourceNameError", "InvalidResourceTypeNameError", "PackageNotFoundError",
        "RESOURCE_INDEX_SUBFOLDER", "get_package_prefix", "get_package_share_directory",
        "get_package_share_path", "get_packages_with_prefixes", "get_resource",
        "get_resource_types", "get_resources", "get_search_paths", "has_resource",
    ],
    ".constants": ["AMENT_PREFIX_PATH_ENV_VAR", "RESOURCE_INDEX_SUBFOLDER"],
    ".packages": [
        "PackageNotFoundError", "get_package_prefix", "get_package_share_directory",
        "get_package_share_path", "get_packages_with_prefixes",
    ],
    ".resources": [
        "InvalidResourceNameError", "InvalidResourceTypeNameError", "get_resource",
        "get_resource_types", "get_resources", "has_resource",
    ],
    ".search_paths": ["get_search_paths"],
}  # fmt: skip


@pytest.fixture(autouse=True)
def robot(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Make a workspace around the current folder with a package, and a prefix with another."""
    folder = tmp_path / "src" / "robot"
    (folder / "msg").mkdir(parents=True)
    (folder / "msg" / "Beep.msg").write_text("int32 times\n")
    (folder / "package.xml").write_text("<package><name>robot</name></package>")
    index = tmp_path / "ros" / "share" / "ament_index" / "resource_index"
    for kind, text in {"packages": "", "plugins": "a plugin"}.items():
        (index / kind).mkdir(parents=True)
        (index / kind / "rover").write_text(text)
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    monkeypatch.setenv("AMENT_PREFIX_PATH", str(tmp_path / "ros"))
    return folder


@pytest.mark.parametrize("module", list(NAMES))
def test_every_name_of_the_package_exists(module: str) -> None:
    imported: Any = importlib.import_module(f"ament_index_python{module}")
    assert [name for name in NAMES[module] if not hasattr(imported, name)] == []


def test_share_folders_are_found(robot: Path) -> None:
    assert ament_index.get_package_share_directory("robot") == str(robot)
    assert ament_index.get_package_share_path("robot") == robot
    prefix = Path(ament_index.get_package_prefix("robot"))
    assert (prefix / "share" / "robot" / "msg" / "Beep.msg").is_file()


def test_a_missing_share_folder_causes_a_warning(tmp_path: Path) -> None:
    share = str(tmp_path / "ros" / "share" / "rover")
    with pytest.warns(UserWarning, match="Share directory for rover .* does not exist") as caught:
        assert ament_index.get_package_share_directory("rover") == share
    assert caught[0].filename.endswith("ament_index.py")
    assert ament_index.get_package_share_directory("rover", print_warning=False) == share


def test_packages_are_listed_with_their_prefixes(tmp_path: Path) -> None:
    found = ament_index.get_packages_with_prefixes()
    assert found["rover"] == str(tmp_path / "ros")
    assert found["robot"] == ament_index.get_package_prefix("robot")
    assert {"rclpy", "std_msgs"} & set(found)


def test_resources_are_read(tmp_path: Path) -> None:
    prefix = str(tmp_path / "ros")
    assert ament_index.get_resource("plugins", "rover") == ("a plugin", prefix)
    assert ament_index.get_resources("plugins") == {"rover": prefix}
    assert ament_index.has_resource("plugins", "rover") == prefix
    assert ament_index.has_resource("plugins", "robot") is False
    assert ament_index.has_resource("packages", "robot")
    assert ament_index.get_resource("rosidl_interfaces", "robot")[0] == "msg/Beep.msg"
    assert {"packages", "plugins", "rosidl_interfaces"} <= ament_index.get_resource_types()
    assert prefix in ament_index.get_search_paths()


def test_mistakes_raise_the_documented_errors() -> None:
    with pytest.raises(InvalidResourceTypeNameError, match="Resource type 'a/b' is invalid"):
        ament_index.get_resources("a/b")
    with pytest.raises(InvalidResourceNameError, match="is invalid"):
        ament_index.get_resource("packages", "../robot")
    with pytest.raises(ResourceNotFoundError, match="Could not find the resource 'x' of type 'y'"):
        ament_index.get_resource("y", "x")
