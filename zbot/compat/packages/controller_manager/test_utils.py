"""Checks for tests of robots with controllers."""

from zbot.launch.testing.controllers import (
    check_controllers_running,
    check_if_js_published,
    check_node_running,
)
