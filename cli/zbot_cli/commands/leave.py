"""`zbot leave`: be alone again."""

from __future__ import annotations

from zbot_cli.output.listing import new_app

app = new_app("Leave what this machine has joined", has_verbs=False)


@app.command()
def leave() -> None:
    """Leave what this machine has joined."""
    from zbot.classroom import student  # noqa: PLC0415 - help is quick
    from zbot.classroom.errors import NotJoinedError  # noqa: PLC0415 - as above

    left = student.leave()
    if left is None:
        raise NotJoinedError
    print(f"left {left.class_name or left.host}")
