"""Rule of a class about the sensors of browsers: the teacher can forbid to publish them.

The live page of each machine of the class asks for the rule, and follows it. Other programs of a
student can still publish the pictures of a camera.
"""

from __future__ import annotations

from zbot.classroom.hub import running_hub
from zbot.classroom.hub.queries import hub_facts
from zbot.classroom.teacher.class_record import load_record
from zbot.errors import ZbotError
from zbot.transport import membership

FORBIDDEN = "The teacher has switched off the sensors of browsers in this class."
_NO_ANSWER = "The class does not answer, so the page does not know whether it allows sensors."


def sensors_refusal() -> str | None:
    """Return why the page may not publish the sensors of browsers, or None if it may.

    A laptop asks the class, which may take two seconds, so call this function in a thread. A laptop
    whose hub is not linked with a class at the moment may publish, because the class gets nothing.
    """
    try:
        joined = membership.load()
        if joined is None or not joined.in_class:
            return None
        if joined.role == "teacher":
            return None if load_record().has_sensors else FORBIDDEN
        return _refusal_of_class()
    except ZbotError as error:
        return str(error)


def _refusal_of_class() -> str | None:
    hub = running_hub.find()
    facts = {} if hub is None else hub_facts(hub.pid)
    if not facts.get("linked"):
        return None
    told = facts.get("of_class")
    if not isinstance(told, dict):
        return _NO_ANSWER
    # A class of an older version of zbot has no rule.
    return FORBIDDEN if told.get("sensors") is False else None
