"""`zbot daemon`: says that zbot has no daemon, for lesson sheets that use `ros2 daemon`."""

from __future__ import annotations

from zbot_cli.output.listing import new_app

app = new_app("Say that no daemon is needed")

_TEXT = "zbot has no daemon and needs none: every command sees the running nodes directly"


@app.command("status")
def status() -> None:
    """Say that zbot has no daemon."""
    print(_TEXT)


@app.command("start")
def start() -> None:
    """Say that no daemon has to be started."""
    print(_TEXT)


@app.command("stop")
def stop() -> None:
    """Say that no daemon has to be stopped."""
    print(_TEXT)
