"""Tests of definitions and classes against ROS 2's own; no hash covers constants and defaults.

Set ZBOT_ROS2_PREFIX to the prefix of a Python environment with the wheels of ROS 2, installed by
`pip install ros-rclpy ros-common-interfaces`.
"""

from __future__ import annotations

import json
import os
import subprocess
from pathlib import Path

import pytest

from zbot.interfaces import (
    MessageSpec,
    ServiceSpec,
    get_interface,
    get_spec,
    interface_names,
    type_hash,
)
from zbot.interfaces.location import shipped_packages
from zbot.interfaces.parser import parse

_PREFIX = os.environ.get("ZBOT_ROS2_PREFIX", "")
_SHARE = Path(_PREFIX) / "share"

pytestmark = [
    pytest.mark.ros2,
    pytest.mark.skipif(
        not (_PREFIX and (_SHARE / "std_msgs" / "msg" / "String.msg").is_file()),
        reason="ZBOT_ROS2_PREFIX names no folder with the definitions of a genuine ROS 2",
    ),
]


def messages(name: str, text: str | None = None) -> list[MessageSpec]:
    spec = get_spec(name) if text is None else parse(name, text)
    if isinstance(spec, MessageSpec):
        return [spec]
    if isinstance(spec, ServiceSpec):
        return [spec.request, spec.response]
    return [spec.goal, spec.result, spec.feedback]


@pytest.mark.parametrize("package", shipped_packages())
def test_definitions_are_those_of_ros(package: str) -> None:
    if not (_SHARE / package).is_dir():
        pytest.skip(f"{package} has no wheel")
    files = {
        f"{package}/{file.parent.name}/{file.stem}": file.with_suffix(f".{kind}")
        for kind in ("msg", "srv", "action")
        for file in (_SHARE / package / kind).glob("*.idl")
    }
    assert set(interface_names(package)) == set(files)
    for name, file in files.items():
        if not file.exists():
            continue  # a few of test_msgs are written in IDL
        # Fields are compared with their defaults, constants with their values, both in order.
        assert messages(name) == messages(name, file.read_text(encoding="utf-8"))


# Runs in the environment of ROS 2, where only zbot's interfaces can be imported.
_GENUINE = """
import importlib, json, sys, types
zbot = types.ModuleType("zbot")
zbot.__path__ = [sys.argv[1]]
sys.modules["zbot"] = zbot
from zbot.interfaces import spec_of, type_hash
facts = {}
for name in sys.argv[2:]:
    package, kind, short = name.split("/")
    module = importlib.import_module(f"{package}.{kind}")
    owner, _, part = short.partition("_")
    cls = getattr(getattr(module, owner), part) if part else getattr(module, owner)
    facts[name] = {
        "repr": repr(cls()),
        "types": cls.get_fields_and_field_types(),
        "name": spec_of(cls).name,
        "hash": type_hash(cls),
    }
print(json.dumps(facts))
"""


def test_classes_are_those_of_ros() -> None:
    names = [
        message.name
        for package in shipped_packages()
        if (_SHARE / package).is_dir()
        for name in interface_names(package)
        for message in messages(name)
    ]
    python = next(
        path for path in (Path(_PREFIX, "bin/python"), Path(_PREFIX, "python.exe")) if path.exists()
    )
    zbot = Path(__file__).parents[3] / "zbot"
    result = subprocess.run(
        [python, "-c", _GENUINE, str(zbot), *names], capture_output=True, text=True, check=True
    )
    genuine = json.loads(result.stdout)
    ours = {
        name: {
            "repr": repr(get_interface(name)()),
            "types": get_interface(name).get_fields_and_field_types(),
            "name": name,
            "hash": type_hash(name),
        }
        for name in names
    }
    assert ours == genuine
