"""`zbot status`: shows the classroom or machine that was joined, and whether the link works."""

from __future__ import annotations

from typing import Any

from zbot_cli.output.listing import AsJson, new_app, print_json

app = new_app("Show the class or the other machine", has_verbs=False)


@app.command()
def status(as_json: AsJson = False) -> None:
    """Show the class or machine that was joined, and whether this machine is linked."""
    from zbot.classroom.state import present_state  # noqa: PLC0415 - not needed by `--help`

    state = present_state()
    print_json(state) if as_json else print("\n".join(_lines(state)))


def _lines(state: dict[str, Any]) -> list[str]:
    if state["role"] is None:
        return ["this machine has joined nothing: its nodes see only each other"]
    lines = [_role(state)]
    if not state["hub"]:
        again = "zbot class start" if state["role"] == "teacher" else "zbot join"
        lines.append(f"the hub of this machine is not running: `{again}` starts it again")
    elif state["role"] in {"student", "partner"}:
        where = f"{state['host']}:{state['port']}"
        reason = state["problem"] or f"{where} does not answer"
        lines.append("linked" if state["linked"] else f"not linked: {reason}")
    return lines + [f"the teacher said: {text}" for text in state["notices"]]


def _role(state: dict[str, Any]) -> str:
    where = f"{state['host']}:{state['port']}"
    match state["role"]:
        case "student":
            return (
                f'{state["name"]}, number {state["number"]} in "{state["class"]}" at {where}: '
                f"nodes are in domain {state['number']}"
            )
        case "teacher":
            return f'teacher of "{state["class"]}", which is open at {where}'
        case "partner":
            return f"joined {where}"
    return "a hub that other machines can join"
