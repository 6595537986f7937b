"""Machines of a page, such as the teacher's and a student's. All are simulated on this machine."""

from __future__ import annotations

import os
import re
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from tests.classroom.local_machine import LocalMachine

if TYPE_CHECKING:
    from collections.abc import Sequence

#: What the pages say about machines: an address, a port, and the number of a student.
ADDRESS, NUMBERS = "192.168.1.10:7447", ("17", "18")
PIN = "402917"


class Machines:
    """Variables of the machines of a page. All of them are simulated on this machine.

    Args:
        folder: For their settings.
        numbers: Unused domains of this machine, which are numbers of students.
    """

    def __init__(self, folder: Path, numbers: Sequence[int]) -> None:
        self._folder = folder
        self._numbers = numbers
        self._machines: dict[str, LocalMachine] = {}

    def environment(self, name: str) -> dict[str, str]:
        """Return the variables of a machine. That of a prompt without a name has the name `""`."""
        own = dict(os.environ)
        if name:
            machine = self._machines.setdefault(name, LocalMachine(self._folder / name))
            own = {**machine.environment, "ZBOT_PIN": PIN}
            del own["ZBOT_DOMAIN_ID"]
        path = os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]])
        return {**own, "PATH": path, "PYTHONUNBUFFERED": "1", "COLUMNS": "80"}

    def translate(self, text: str) -> str:
        """Return a text of a page with the address and the number of this test."""
        if not self._machines:
            return text
        (first, *_) = self._machines.values()
        text = re.sub("^zbot hub$", f"zbot hub --listen 127.0.0.1:{first.port}", text)
        text = text.replace("on 0.0.0.0:7447", f"on 127.0.0.1:{first.port}")
        text = text.replace(ADDRESS, f"127.0.0.1:{first.port}")
        # In one pass: the own number for 17 may be 18.
        own = dict(zip(NUMBERS, map(str, self._numbers), strict=True))
        return re.sub(rf"(?<![\d.])({'|'.join(own)})\b", lambda found: own[found[1]], text)

    def switch_off(self) -> None:
        """Switch all machines off."""
        unnamed = LocalMachine(Path(os.environ["XDG_CONFIG_HOME"]))
        for machine in (*reversed(self._machines.values()), unnamed):
            machine.switch_off()
