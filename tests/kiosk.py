"""Program whose texts can contain anything, in every field that commands and pages show."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tests.conftest import Program, Start

_PROGRAM = Path(__file__).parent / "programs" / "hostile" / "hostile_kiosk.py"
_TYPES = {
    "package.xml": "<package><name>kiosk</name></package>",
    "msg/Menu.msg": "# {text}\nstring dish\n",
    "srv/Order.srv": "# {text}\nstring dish\n---\nstring receipt\n",
    "action/Boil.action": "# {text}\nint32 order\n---\nstring dish\n---\nstring state\n",
}


def start_kiosk(start: Start, folder: Path, text: str) -> Program:
    """Start the program with a text. Others learn its types from the network.

    Args:
        start: The fixture that starts programs.
        folder: Folder for the definitions of its types.
        text: The text of all fields.
    """
    for name, pattern in _TYPES.items():
        path = folder / "kiosk" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(pattern.format(text=text), encoding="utf-8")
    program = start("zbot", "run", str(_PROGRAM), text, env={"ZBOT_WORKSPACE": str(folder)})
    program.wait_for("ready")
    return program
