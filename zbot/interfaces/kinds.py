"""Kinds of interface definitions."""

from __future__ import annotations

#: The same words are folders in a package, file name extensions and middle parts of full names.
KINDS = ("msg", "srv", "action")
