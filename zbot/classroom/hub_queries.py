"""Questions that a hub answers about itself, for the commands of its machine and its teacher."""

from __future__ import annotations

import json
import threading
from typing import TYPE_CHECKING, Any

import zenoh

from zbot.log import get_logger

if TYPE_CHECKING:
    from collections.abc import Callable

_QUEUE = 256
_LARGEST = 64 * 1024  # bytes; what strangers send has a few hundred
_LARGEST_ANSWER = 16 * 1024 * 1024  # a class of 232 with a hundred nodes each

Answer = dict[str, Any]


class HubQueries:
    """Answers the queries on one key, one after the other, in a thread of its own.

    Its `thread` ends when the session is closed.

    Args:
        session: The hub's.
        key: Key expression, without wildcards.
        answer: Gets a query's document and returns another; what it raises is told to the asker.
    """

    def __init__(
        self, session: zenoh.Session, key: str, answer: Callable[[Answer], Answer | None]
    ) -> None:
        self._key = key
        self._answer = answer
        self._queryable = session.declare_queryable(
            key, zenoh.handlers.FifoChannel(_QUEUE), complete=True
        )
        self._at_work = threading.Lock()
        self.thread = threading.Thread(target=self._run, name=f"zbot desk {key}", daemon=True)
        self.thread.start()

    def _run(self) -> None:
        receive = self._queryable.handler.recv
        while True:
            try:
                query = receive()
            except zenoh.ZError:
                return  # the session was closed
            with self._at_work:
                self._serve(query)

    def finish(self) -> None:
        """Wait until the question that is being answered, if any, is."""
        with self._at_work:
            return

    def _serve(self, query: zenoh.Query) -> None:
        with query:  # the asker waits until it is left
            try:
                answer = self._answer(document_of(query.payload))
                if answer is not None:
                    query.reply(self._key, json.dumps(answer))
            except zenoh.ZError:
                return  # the asker has gone
            except Exception as exc:  # noqa: BLE001 - one bad question must not end the desk
                get_logger("hub").error(f"a question on {self._key} failed: {exc!r}")
                query.reply_err(json.dumps({"error": type(exc).__name__, "message": str(exc)}))


def document_of(payload: zenoh.ZBytes | None, largest: int = _LARGEST) -> Answer:
    """Return the JSON object of a payload; empty if it is none, or larger than some bytes."""
    if payload is None or len(payload) > largest:
        return {}
    try:
        found = json.loads(payload.to_bytes())
    except (ValueError, RecursionError):
        return {}
    return found if isinstance(found, dict) else {}


def ask(
    session: zenoh.Session, key: str, question: Answer | None = None, *, timeout_s: float
) -> list[Answer]:
    """Return the answers to a question, those that come in time."""
    replies = session.get(key, payload=json.dumps(question or {}), timeout=timeout_s)
    return [
        document_of(reply.ok.payload, _LARGEST_ANSWER) for reply in replies if reply.ok is not None
    ]
