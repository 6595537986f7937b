# Written by python -m zbot.compat.generator; do not edit.
"""Function that ends the launch when a process ends."""

from zbot.launch.actions import shutdown_on_process_exit

__all__ = [
    "shutdown_on_process_exit",
]
