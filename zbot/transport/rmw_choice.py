"""Choice of a program's middleware: zbot's own, or ROS 2's. Each has its own wire format."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING

from zbot.transport.errors import SettingError
from zbot.wire.dialect import CLASSROOM, NATIVE, RMW_ZENOH, ZBOT_IDENTIFIER

if TYPE_CHECKING:
    from zbot.transport.config import SessionConfig
    from zbot.wire.dialect import Dialect

__all__ = ["IDENTIFIERS", "RMW_VARIABLE", "RMW_ZENOH", "dialect_of_rmw", "known"]

RMW_VARIABLE = "RMW_IMPLEMENTATION"
#: Names of the middlewares that a program can choose.
IDENTIFIERS = (ZBOT_IDENTIFIER, RMW_ZENOH)


def dialect_of_rmw(
    given: str | None, *, in_class: bool, file: SessionConfig | None = None
) -> Dialect:
    """Return the dialect (wire format) of a context's middleware.

    The middleware is `given`, else `$RMW_IMPLEMENTATION`, else the value in the configuration file.
    If the variable has another middleware of ROS 2, it is ignored, because the user may have set it
    for other programs.

    Args:
        given: Name of a middleware.
        in_class: Whether the machine is in a class.
        file: The Zenoh configuration file, if it was read. Its `metadata` may have the field
            `rmw_implementation`.

    Raises:
        SettingError: The middleware in `given` or in the file is unknown, or the file is not a
            valid Zenoh configuration.
    """
    found = given or _of_variable() or (file and _of_file(file))
    name = known(found) if found else ZBOT_IDENTIFIER
    if name == RMW_ZENOH:
        from zbot.wire.rmw_zenoh import ROS2  # noqa: PLC0415 - rarely needed

        return ROS2
    return CLASSROOM if in_class else NATIVE


def known(name: str) -> str:
    """Return a middleware's name if zbot supports this middleware.

    Raises:
        SettingError: zbot does not support the middleware.
    """
    if name not in IDENTIFIERS:
        raise SettingError(f"zbot does not speak {name!r}: choose {' or '.join(IDENTIFIERS)}")
    return name


def _of_variable() -> str | None:
    name = os.environ.get(RMW_VARIABLE)
    return name if name in IDENTIFIERS else None


def _of_file(file: SessionConfig) -> str | None:
    if "rmw_implementation" not in file.text or file.is_packaged:
        return None
    from zbot.transport.config import setting  # noqa: PLC0415 - few files have it

    metadata = setting(file.build({}), "metadata")
    name = metadata.get("rmw_implementation") if isinstance(metadata, dict) else None
    return None if name is None else str(name)
