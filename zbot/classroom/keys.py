"""Key expressions and limits that the hubs of a class use (see docs/wire.md)."""

from __future__ import annotations

from zbot.security.access import LOBBY_SPACE, STUDENT_SPACE, TEACHER_SPACE

HERE = "here"
ADMISSION_KEY = f"{LOBBY_SPACE}/door"  #: queries from laptops that join or leave
NOTICES_KEY = f"{TEACHER_SPACE}/notices"  #: queries for earlier notices
ROBOTS_KEY = f"{TEACHER_SPACE}/robots"  #: messages with the driver of each robot
#: A hub answers queries on `@hub/<process id>` with facts about itself.
HUB_KEY = "@hub"
#: Largest number of nodes of one student that a class lists.
MAX_LISTED_NODES = 200
COMMAND_KEY = "@class/desk"  #: queries from the teacher's commands


def here_key(number: int) -> str:
    """Return the key of the liveliness token of a student's laptop."""
    return f"{STUDENT_SPACE}/{number}/{HERE}"


def facts_key(number: int) -> str:
    """Return the key on which a student's laptop answers with facts about itself."""
    return f"{STUDENT_SPACE}/{number}/facts"


def nodes_selector(number: int) -> str:
    """Return the selector of the tokens of a student's nodes."""
    return f"@zbot/{number}/*/*/*/NN/**"
