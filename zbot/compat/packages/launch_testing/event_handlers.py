# Written by python -m zbot.compat.generator; do not edit.
"""Handler that detects when a process is ready."""

from zbot.launch.testing.ready_listener import StdoutReadyListener

__all__ = [
    "StdoutReadyListener",
]
