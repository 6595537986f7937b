"""Tests of the source of the call by which a program called zbot."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from zbot.errors.call_source import OWN_FILES, calling_line

_CALLER = "def call(function):\n    return function()\n"


@pytest.mark.parametrize("package", ["zbot_nodes", "zbot_demo"])
def test_the_packages_beside_the_library_are_not_its_own(package: str) -> None:
    beside = Path(OWN_FILES).parent / package / "talker.py"
    code: dict[str, Any] = {"__name__": f"{package}.talker"}
    exec(compile(_CALLER, str(beside), "exec"), code)
    line = code["call"](calling_line)
    assert line == ("" if package == "zbot_nodes" else f"{beside}:2")
