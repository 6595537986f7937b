"""`zbot leave`: ends the link that `zbot join` made."""

from __future__ import annotations

from zbot_cli.output.listing import new_app

app = new_app("Leave the class or the other machine", has_verbs=False)


@app.command()
def leave() -> None:
    """Leave the class or the other machine."""
    from zbot.classroom import student  # noqa: PLC0415 - not needed by `--help`
    from zbot.classroom.errors import NotJoinedError  # noqa: PLC0415 - as above

    left = student.leave()
    if left is None:
        raise NotJoinedError
    print(f"left {left.class_name or left.host}")
