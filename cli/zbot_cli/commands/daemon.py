"""`zbot daemon`: there is none, and lesson sheets may ask for it."""

from __future__ import annotations

from zbot_cli.output.listing import new_app

app = new_app("Say that no daemon is needed")

_TEXT = "zbot has no daemon and needs none: every command sees the running nodes directly"


@app.command("status")
def status() -> None:
    """Say that there is none."""
    print(_TEXT)


@app.command("start")
def start() -> None:
    """Say that none is needed."""
    print(_TEXT)


@app.command("stop")
def stop() -> None:
    """Say that there is none to stop."""
    print(_TEXT)
