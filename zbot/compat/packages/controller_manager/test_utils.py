# Written by python -m zbot.compat.generator; do not edit.
"""Checks for tests of robots with controllers."""

from zbot.launch.testing.controllers import (
    check_controllers_running,
    check_if_js_published,
    check_node_running,
)

__all__ = [
    "check_controllers_running",
    "check_if_js_published",
    "check_node_running",
]
