"""The keys with which the hubs of a class speak to each other (see docs/wire.md)."""

from __future__ import annotations

from zbot.security.access import LOBBY_SPACE, STUDENT_SPACE, TEACHER_SPACE

HERE = "here"
DOOR_KEY = f"{LOBBY_SPACE}/door"  #: where strangers ask to be let in
NOTICES_KEY = f"{TEACHER_SPACE}/notices"  #: answers with what was said before
DESK_KEY = "@class/desk"  #: what the teacher's own commands ask


def here_key(number: int) -> str:
    """Return the token of a student's laptop."""
    return f"{STUDENT_SPACE}/{number}/{HERE}"


def facts_key(number: int) -> str:
    """Return what a student's laptop answers about itself."""
    return f"{STUDENT_SPACE}/{number}/facts"


def nodes_selector(number: int) -> str:
    """Return the tokens of a student's nodes."""
    return f"@zbot/{number}/*/*/*/NN/**"
