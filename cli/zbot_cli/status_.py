"""`zbot status`: what this machine has joined, and whether it is linked."""

from __future__ import annotations

from typing import Any

from zbot_cli.listing import AsJson, new_app, print_json

app = new_app("Show what this machine has joined", has_verbs=False)


@app.command()
def status(as_json: AsJson = False) -> None:
    """Show what this machine has joined, and whether it is linked."""
    from zbot.classroom.state import present_state  # noqa: PLC0415 - help is quick

    state = present_state()
    print_json(state) if as_json else print(_text(state))


def _text(state: dict[str, Any]) -> str:
    if state["role"] is None:
        return "this machine has joined nothing: its nodes see only each other"
    lines = [f"{state['role']} at {state['host']}:{state['port']}"]
    if not state["hub"]:
        lines.append("its hub does not run: zbot leave, then join again")
    else:
        lines.append("linked" if state["linked"] else "not linked: the other hub does not answer")
    return "\n".join(lines)
