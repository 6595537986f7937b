"""Addresses of files with surfaces in robot descriptions and messages."""

from __future__ import annotations

from pathlib import Path
from urllib.parse import unquote, urlsplit

from zbot.errors import ZbotError
from zbot.libraries.robot_description.xml_text import DescriptionError
from zbot.package import package_share


def path_of(address: str) -> Path:
    """Return the path of a file on this machine.

    Raises:
        DescriptionError: The address is not that of a file of this machine, or the package is
            missing.
    """
    try:
        parts = urlsplit(address)
    except ValueError as error:
        raise DescriptionError(f"{address} is not an address: {error}") from error
    if parts.scheme == "package":
        try:
            return package_share(parts.netloc) / unquote(parts.path).lstrip("/")
        except ZbotError as error:
            raise DescriptionError(f"{address} is not found: {error}") from error
    if parts.scheme == "file":
        # A host would be another machine: Windows would send it the name of the user.
        if parts.netloc:
            raise DescriptionError(f"{address} is on another machine: write file:///PATH")
        return Path(unquote(parts.path))
    if "://" in address or address.startswith(("//", "\\\\")):
        raise DescriptionError(
            f"{address} cannot be read: write package://PACKAGE/PATH or file:///PATH"
        )
    return Path(address)
