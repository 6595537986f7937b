"""Arrangement in the address of a view, so that a link shares it."""

from __future__ import annotations

import base64
import binascii
import zlib
from dataclasses import replace
from typing import TYPE_CHECKING

from zbot.view.arrangement.errors import ArrangementError
from zbot.view.arrangement.rviz_file import read_rviz
from zbot.view.arrangement.rviz_writer import rviz_text

if TYPE_CHECKING:
    from zbot.view.arrangement.arrangement import Arrangement

#: Parameter of the query that contains an arrangement.
PARAMETER = "arrangement"
#: Browsers and the guard accept addresses that are a little longer.
MOST_CHARACTERS = 8000
_MOST_BYTES = 200_000


def link_text(arrangement: Arrangement) -> str:
    """Return the value of the parameter for an arrangement. It has only what the view has.

    Raises:
        ArrangementError: The arrangement is too large for an address.
    """
    own = (choice for choice in arrangement.displays if choice.kind and not choice.file)
    displays = tuple(replace(choice, raw={}) for choice in own)
    bare = replace(arrangement, displays=displays, raw={}, misfits=())
    data = rviz_text(bare).encode()
    text = base64.urlsafe_b64encode(zlib.compress(data, 9)).decode().rstrip("=")
    if len(data) > _MOST_BYTES or len(text) > MOST_CHARACTERS:
        raise ArrangementError("the arrangement is too large for a link: save it in a file")
    return text


def read_link(text: str) -> Arrangement:
    """Return the arrangement of a parameter. It names no file of this machine.

    Raises:
        ArrangementError: The text is not a value of `link_text`.
    """
    try:
        packed = base64.urlsafe_b64decode(text.encode() + b"=" * (-len(text) % 4))
        unpacking = zlib.decompressobj()
        data = unpacking.decompress(packed, _MOST_BYTES)
        if not unpacking.eof:
            raise ArrangementError("the link has no end, or is too large")
        found = read_rviz(data.decode())
    except (binascii.Error, zlib.error, UnicodeError, ValueError) as error:
        raise ArrangementError(f"the link has no arrangement: {error}") from error
    return replace(found, displays=tuple(replace(one, file="") for one in found.displays))
