"""Handler that detects when a process is ready."""

from zbot.launch.testing.ready_listener import StdoutReadyListener
