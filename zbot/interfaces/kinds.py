"""The kinds of interface definitions."""

from __future__ import annotations

#: Folders of a package, endings of its files, and the middle of full names.
KINDS = ("msg", "srv", "action")
