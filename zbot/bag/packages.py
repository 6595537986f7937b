"""Packages of the extra `bag`. They are imported only when a bag is read or written."""

from __future__ import annotations

import importlib

from zbot.bag.errors import NoBagExtraError


def import_mcap() -> None:
    """Check that MCAP files can be read and written.

    Raises:
        NoBagExtraError: A package is not installed.
    """
    for name in ("mcap", "zstandard"):
        try:
            importlib.import_module(name)
        except ImportError:
            raise NoBagExtraError(name) from None
