"""LaptopReport of a laptop in a class: its liveliness token, and the facts that it reports."""

from __future__ import annotations

import json
import platform
import socket
import time
from typing import TYPE_CHECKING, Any

import zenoh

from zbot.classroom.hub.queries import ask, document_of
from zbot.classroom.join_request import proof
from zbot.classroom.keys import NOTICES_KEY, facts_key, here_key, nodes_selector
from zbot.interfaces import get_message
from zbot.log.teacher_notice import NOTICE_KEY, notice_text
from zbot.threads.foreign_call import called_by_zenoh
from zbot.transport import admin_query
from zbot.version import __version__
from zbot.wire.errors import CodecError
from zbot.wire.messagepack.codec import messagepack_codec_for

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.classroom.hub.process import HubProcess
    from zbot.transport.membership import Membership

_ERROR_LEVEL = 40  # ERROR in rcl_interfaces/msg/Log (FATAL is 50)
_QUEUE = 64
_MAX_TEXT = 300
_NOTICES_TIMEOUT_S = 4.0  # the class answers immediately, but a slow network needs time
_QUERY_TIMEOUT_S = 0.5
_MAX_LOG_BYTES = 64 * 1024


class LaptopReport:
    """Declares the token of a student's laptop, and answers queries for its facts.

    Args:
        joined: The laptop's membership in the class.
    """

    def __init__(self, joined: Membership) -> None:
        self._joined = joined
        self._last_error: dict[str, Any] | None = None
        self._known: set[str] = set()
        self._codec = messagepack_codec_for(get_message("rcl_interfaces/msg/Log"))

    def attach(self, serving: HubProcess) -> None:
        """Declare the token on this laptop's open hub, and begin to answer the teacher there."""
        number = self._joined.number
        self._serving = serving
        session = serving.session
        logs = session.declare_subscriber(f"{number}/rosout", zenoh.handlers.RingChannel(_QUEUE))
        serving.keep(logs)
        serving.start_thread("zbot last error", self._read_logs, logs.handler.recv)
        self._is_closed = False
        hear = called_by_zenoh(self._hear_notice)
        serving.keep(session.declare_subscriber(NOTICE_KEY, hear))
        serving.extra_facts["of_class"] = self.of_class
        serving.extra_facts["closed"] = lambda: self._is_closed
        serving.answer_queries(facts_key(number), self._facts)
        serving.keep(session.liveliness().declare_token(here_key(number)))

    def _hear_notice(self, sample: zenoh.Sample) -> None:
        self._is_closed = document_of(sample.payload).get("closed") is True

    def of_class(self) -> dict[str, Any] | None:
        """Ask the class for its notices, and for what only the owner of the number may know.

        The owner gets the nodes of this laptop that the class sees, the numbers of the other
        students with the same name, and whether the class sees this laptop. `sensors` says whether
        pages may publish the sensors of browsers. Return `None` if the class does not answer. A
        class does not answer a laptop that it does not accept.
        """
        number = self._joined.number
        question = {"number": number, "proof": proof(self._joined.claim, "nodes")}
        answers = ask(self._serving.session, NOTICES_KEY, question, timeout_s=_NOTICES_TIMEOUT_S)
        if not answers:
            return None
        notices = answers[0].get("notices")
        notices = notices if isinstance(notices, list) else []
        texts = [notice_text(json.dumps(notice).encode()) for notice in notices]
        return {
            "notices": texts,
            "nodes": answers[0].get("nodes"),
            "namesakes": answers[0].get("namesakes"),
            "here": answers[0].get("here"),
            "sensors": answers[0].get("sensors"),
        }

    def _facts(self, _question: dict[str, Any]) -> dict[str, Any]:
        time_ns = time.time_ns()  # first: the class assumes the middle of its waiting time
        self._query_earlier_logs()
        return {
            "number": self._joined.number,
            "name": self._joined.name,
            "host": socket.gethostname(),
            "system": platform.system(),
            "version": __version__,
            "time_ns": time_ns,
            "last_error": self._last_error,
        }

    def _query_earlier_logs(self) -> None:
        """Query the logs that new nodes published before this hub was linked with them."""
        selector = nodes_selector(self._joined.number)
        session = self._serving.session
        found = set(admin_query.tokens(session, selector, _QUERY_TIMEOUT_S))
        if found <= self._known:
            self._known = found
            return
        self._known = found
        # This query asks transient local publishers for their cached messages (zenoh.ext).
        for reply in session.get(
            f"{self._joined.number}/rosout/@adv/pub/**?_max={_QUEUE}",
            admin_query.large_queue(),
            consolidation=zenoh.ConsolidationMode.NONE,
            accept_replies=zenoh.ReplyKeyExpr.ANY,
            timeout=_QUERY_TIMEOUT_S,
        ):
            if reply.ok is not None:
                self._note(reply.ok.payload.to_bytes())

    def _read_logs(self, receive: Callable[[], zenoh.Sample]) -> None:
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
            return  # other programs may publish anything on /rosout
        stamp_ns = line.stamp.sec * 10**9 + line.stamp.nanosec
        latest_ns = self._last_error["time_ns"] if self._last_error else 0
        if line.level >= _ERROR_LEVEL and stamp_ns >= latest_ns:
            self._last_error = {
                "node": line.name[:_MAX_TEXT],
                "text": line.msg[:_MAX_TEXT],
                "time_ns": stamp_ns,
            }
