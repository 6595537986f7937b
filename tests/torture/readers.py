"""List of all readers of foreign bytes or text. A test checks that no module is missing in it."""

from __future__ import annotations

from tests.torture.reader import readers

READERS = tuple(readers())

#: Modules that call a parser, but have no reader in the list. The value is the reason.
EXCEPTIONS = {
    "zbot.classroom.bundle.installer": "it reads the bundle that the user installs anyway",
    "zbot.classroom.bundle.own_wheel": "it reads only the direct_url.json that pip writes",
    "zbot.classroom.bundle.resolver": "it reads what uv writes",
    "zbot.classroom.bundle.service": "it reads only the file that this user's own service writes",
    "zbot.classroom.hub.running_hub": "it reads only the file that this user's own hub writes",
    "zbot.compat.table": "it reads only the tables that zbot contains",
    "zbot.errors.call_source": "it reads the program that runs in this process",
    "zbot.package.finder": "it reads only the direct_url.json that pip writes",
    "zbot.node.service": "the attachment has the right length, which _request_id checks",
    "zbot.node.service_introspection": "it reads the bytes that zbot.node.service has checked",
    "zbot.node.pending_calls": "it reads an attachment that this process has packed",
    "zbot.transport.config": "it reads the settings that Zenoh has checked",
    "zbot.transport.environment": "it reads the settings that Zenoh has checked",
    "zbot.launch.control.running_launch": "it reads what this user's own launches answer",
    "zbot.transport.program_file": "it reads the files that this user's programs write",
    "zbot.view.server.embedded_view": "it reads the address that its own process prints",
    "zbot.web.server.request_check": "the library's parsers of addresses raise only ValueError",
    "zbot.web.rosbridge.frame": "it makes a picture of the text that this process has written",
    "zbot.process.main_part": "it reads the program that the user runs anyway",
    "zbot.launch.python_file": "it reads the launch file that the user runs anyway",
    "zbot.bridge.devices.serial.lost_bytes": "it reads the counts of the kernel",
    "zbot_cli.commands.test": "it reads the tests that the user runs anyway",
    "zbot_cli.packages.known_workspaces": "it reads the list that this user's zbot writes",
    "zbot_nodes.cameras.frame_source": "OpenCV decodes the pictures that the user names",
    "zbot_nodes.turtlesim.world": "it rounds a constant to a 32-bit float",
}
