"""Student whose robot the teacher looks at."""

from __future__ import annotations

from zbot.classroom.teacher import opening
from zbot.observer.errors import ViewerError


def student_domain(text: str) -> int:
    """Return the domain of a student of the class that this machine has opened.

    This asks the class, so call it in a thread.

    Args:
        text: The number of the student.

    Raises:
        ViewerError: The class has no such student.
        ClassCommandError: This machine has opened no class, or the class does not answer.
    """
    students = opening.command({"op": "list"})["students"]
    numbers = {str(student["number"]): int(student["number"]) for student in students}
    if text not in numbers:
        raise ViewerError(f"the class has no student {text[:20]}")
    return numbers[text]
