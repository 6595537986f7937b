"""Queries in JSON between hubs and commands: a queryable with a thread, and a query function."""

from __future__ import annotations

import json
import threading
from typing import TYPE_CHECKING, Any

import zenoh

from zbot.classroom.keys import HUB_KEY
from zbot.log import get_logger
from zbot.text.json_reader import JsonError, read_json_object
from zbot.transport.session import open_hub_client

if TYPE_CHECKING:
    from collections.abc import Callable

_QUEUE = 256
_LARGEST = 64 * 1024  # bytes (a valid query of a laptop that joins has a few hundred bytes)
_FACTS_TIMEOUT_S = 6.0  # a laptop's hub waits for the class at most 4 s
_LARGEST_ANSWER = 16 * 1024 * 1024  # bytes (for 232 students who have 200 nodes each)

Answer = dict[str, Any]


class HubQueries:
    """Queryable on one key. It answers queries one after the other, in its own thread.

    The `thread` ends when the session is closed.

    Args:
        session: The hub's session.
        key: Key expression without wildcards.
        answer: Takes the document of a query and returns the document of the reply. If it returns
            `None`, there is no reply. If it raises an exception, the client gets an error reply.
    """

    def __init__(
        self, session: zenoh.Session, key: str, answer: Callable[[Answer], Answer | None]
    ) -> None:
        self._key = key
        self._answer = answer
        self._queryable = session.declare_queryable(
            key, zenoh.handlers.FifoChannel(_QUEUE), complete=True
        )
        self._answering = threading.Lock()
        self.thread = threading.Thread(target=self._run, name=f"zbot queries {key}", daemon=True)
        self.thread.start()

    def _run(self) -> None:
        receive = self._queryable.handler.recv
        while True:
            try:
                query = receive()
            except zenoh.ZError:
                return  # the session was closed
            with self._answering:
                self._serve(query)

    def finish(self) -> None:
        """Wait for the reply to the query in progress, if there is one."""
        with self._answering:
            return

    def _serve(self, query: zenoh.Query) -> None:
        with query:  # the client waits until the block ends
            try:
                answer = self._answer(document_of(query.payload))
                if answer is not None:
                    query.reply(self._key, json.dumps(answer))
            except zenoh.ZError:
                return  # the client has closed its session
            except Exception as exc:  # noqa: BLE001 - one bad query must not end the thread
                get_logger("hub").error(f"a query on {self._key} failed: {exc!r}")
                query.reply_err(json.dumps({"error": type(exc).__name__, "message": str(exc)}))


def document_of(payload: zenoh.ZBytes | None, largest: int = _LARGEST) -> Answer:
    """Return a payload's JSON object, or `{}` if the payload is invalid or over `largest` bytes."""
    if payload is None or len(payload) > largest:
        return {}
    try:
        return read_json_object(payload.to_bytes(), largest)
    except JsonError:
        return {}


def ask(
    session: zenoh.Session, key: str, question: Answer | None = None, *, timeout_s: float
) -> list[Answer]:
    """Return the replies to a query that arrive within `timeout_s`."""
    replies = session.get(key, payload=json.dumps(question or {}), timeout=timeout_s)
    return [
        document_of(reply.ok.payload, _LARGEST_ANSWER) for reply in replies if reply.ok is not None
    ]


def hub_facts(pid: int) -> dict[str, Any]:
    """Return the facts that this machine's hub reports. Empty if the hub does not answer."""
    session = open_hub_client()
    if session is None:
        return {}
    try:
        answers = ask(session, f"{HUB_KEY}/{pid}", timeout_s=_FACTS_TIMEOUT_S)
    finally:
        session.close()
    return next((answer for answer in answers if answer.get("pid") == pid), {})
