"""What a laptop tells its teacher: that it is there, and some facts when it is asked."""

from __future__ import annotations

import json
import platform
import socket
import threading
import time
from typing import TYPE_CHECKING, Any

import zenoh
import zenoh.ext as advanced

from zbot.classroom.desk import ask
from zbot.classroom.keys import NOTICES_KEY, facts_key, here_key
from zbot.errors import CodecError
from zbot.interfaces import get_message
from zbot.notice import notice_text
from zbot.version import __version__
from zbot.wire.codec import codec_for

if TYPE_CHECKING:
    from zbot.classroom.serving import Serving
    from zbot.membership import Membership

_ERROR_LEVEL = 40  # rcl_interfaces/msg/Log: ERROR; FATAL is 50
_QUEUE = 64
_MAX_TEXT = 300
_NOTICES_TIMEOUT_S = 0.5
_MAX_LOG_BYTES = 64 * 1024


class Presence:
    """A student's laptop, seen from the class.

    Args:
        joined: As whom.
    """

    def __init__(self, joined: Membership) -> None:
        self._joined = joined
        self._last_error: dict[str, Any] | None = None
        self._codec = codec_for(get_message("rcl_interfaces/msg/Log"))

    def equip(self, serving: Serving) -> None:
        """Begin to answer the teacher, and be seen."""
        number = self._joined.number
        # Nodes keep their latest lines, as their first ones may come before this hub is linked.
        self._logs = advanced.declare_advanced_subscriber(
            serving.session,
            f"{number}/rosout",
            zenoh.handlers.RingChannel(_QUEUE),
            history=advanced.HistoryConfig(detect_late_publishers=True, max_samples=_QUEUE),
        )
        thread = threading.Thread(target=self._read_logs, name="zbot last error", daemon=True)
        thread.start()
        serving.join_later(thread)
        serving.tell["notices"] = lambda: said_before(serving.session)
        serving.desk(facts_key(number), self._facts)
        self._token = serving.session.liveliness().declare_token(here_key(number))

    def _facts(self, _question: dict[str, Any]) -> dict[str, Any]:
        return {
            "number": self._joined.number,
            "name": self._joined.name,
            "host": socket.gethostname(),
            "system": platform.system(),
            "version": __version__,
            "time_ns": time.time_ns(),
            "last_error": self._last_error,
        }

    def _read_logs(self) -> None:
        receive = self._logs.handler.recv
        while True:
            try:
                sample = receive()
            except zenoh.ZError:
                return  # the session was closed
            self._note(sample.payload.to_bytes())

    def _note(self, payload: bytes) -> None:
        if len(payload) > _MAX_LOG_BYTES:
            return
        try:
            line: Any = self._codec.decode(payload)
        except CodecError:
            return  # anything may be published on /rosout
        if line.level >= _ERROR_LEVEL:
            self._last_error = {
                "node": line.name[:_MAX_TEXT],
                "text": line.msg[:_MAX_TEXT],
                "time_ns": time.time_ns(),
            }


def said_before(session: zenoh.Session) -> list[str]:
    """Return what the teacher has said to the class, oldest first; empty if it is out of reach."""
    answers = ask(session, NOTICES_KEY, timeout_s=_NOTICES_TIMEOUT_S)
    notices = answers[0].get("notices") if answers else None
    return [notice_text(json.dumps(one).encode()) for one in notices or []]
