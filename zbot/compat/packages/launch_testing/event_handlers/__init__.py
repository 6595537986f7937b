"""When a process is ready."""

from zbot.launch_test.ready_listener import StdoutReadyListener as StdoutReadyListener
