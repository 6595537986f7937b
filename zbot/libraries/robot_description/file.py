"""Files with robot descriptions."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.libraries.robot_description.xml_text import DescriptionError
from zbot.text.limited_file import read_limited

if TYPE_CHECKING:
    from pathlib import Path

_MOST_BYTES = 20_000_000


def read_description(path: Path) -> str:
    """Return the text of a file with a robot description.

    Raises:
        DescriptionError: The file cannot be read, is too large, or is a file for xacro.
    """
    if path.suffix == ".xacro":
        raise DescriptionError(
            f"{path} is a file for xacro: type 'xacro {path} > robot.urdf', and show robot.urdf"
        )
    try:
        data = read_limited(path, _MOST_BYTES)
    except (OSError, ValueError) as error:
        raise DescriptionError(f"{path} cannot be read: {error}") from error
    if len(data) > _MOST_BYTES:
        raise DescriptionError(f"{path} has more than {_MOST_BYTES} bytes")
    try:
        return data.decode("utf-8").replace("\r\n", "\n")
    except UnicodeDecodeError as error:
        raise DescriptionError(f"{path} cannot be read: {error}") from error
