"""`zbot status`: shows the classroom or machine that was joined, and whether the link works."""

from __future__ import annotations

from typing import Any

from zbot.text.terminal import escape_control_characters
from zbot_cli.output.listing import AsJson, new_app, print_json

app = new_app("Show the class or the other machine", has_verbs=False)


@app.command()
def status(as_json: AsJson = False) -> None:
    """Show the class or machine that was joined, and whether this machine is linked."""
    from zbot.classroom.machine_state import present_state  # noqa: PLC0415 - not needed by `--help`

    state = present_state()
    print_json(state) if as_json else print("\n".join(lines(state)))


def lines(state: dict[str, Any]) -> list[str]:
    """Return the state of this machine's membership as text.

    Args:
        state: What `present_state` returns.
    """
    outside = [escape_control_characters(state["outside"])] if state["outside"] else []
    if state["role"] is None:
        return ["this machine has joined nothing: its nodes see only each other", *outside]
    found = [_role(state), *_invitation(state["join"])]
    if not state["hub"]:
        again = "zbot class start" if state["role"] == "teacher" else "zbot join"
        found.append(f"the hub of this machine is not running: `{again}` starts it again")
    elif state["role"] in {"student", "partner"}:
        found.append(_link(state["problem"], is_linked=state["linked"]))
    elif state["problem"]:
        found.append(state["problem"])
    if state["namesakes"]:
        found.append(namesakes_text(state["name"], state["namesakes"]))
    found += [*state["differences"], *outside]
    return found + [f"the teacher said: {text}" for text in state["notices"]]


def _link(problem: str | None, *, is_linked: bool) -> str:
    if problem is None:
        return "linked" if is_linked else "not linked"
    return f"linked, but {problem}" if is_linked else f"not linked: {problem}"


def _invitation(join: dict[str, Any] | None) -> list[str]:
    if join is None:
        return []
    lines = [f"students type: zbot join {join['code'] or join['host']}"]
    lines += [f"PIN: {join['pin']}"] if join["pin"] else []
    if join["former_host"]:
        lines.append(
            f"the address of this machine was {join['former_host']}, and is now {join['host']}: "
            "students who have joined must join again"
        )
    return lines


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


def namesakes_text(name: str, numbers: list[int]) -> str:
    """Return a sentence about the other students of the class who have the same name."""
    is_one = len(numbers) == 1
    who = f"number{'' if is_one else 's'} {', '.join(map(str, numbers))}"
    return (
        f'{who} of the class {"has" if is_one else "have"} the name "{name}" too: to use another '
        "name, type `zbot leave`, and join again with --name"
    )
