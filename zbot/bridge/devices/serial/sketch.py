"""Programs for boards that print lines for `zbot serial`."""

from __future__ import annotations

from importlib.resources import files

from zbot.bridge.devices.errors import DeviceError
from zbot.errors.suggestion import did_you_mean

_FILES = {
    "arduino": "arduino.ino",
    "micropython": "micropython.txt",
    "circuitpython": "circuitpython.txt",
}


def sketch_for(board: str) -> str:
    """Return a program.

    Args:
        board: `arduino`, `micropython` or `circuitpython`.

    Raises:
        DeviceError: There is no program for this kind of board.
    """
    file = _FILES.get(board.lower())
    if file is None:
        known = ", ".join(_FILES)
        raise DeviceError(
            f"there is no program for {board!r}: choose one of {known}",
            hint=did_you_mean(board, _FILES),
        )
    return (files("zbot.bridge.devices.serial") / "sketches" / file).read_text(encoding="utf-8")
