"""Running launches of this user on this machine, and requests to them."""

from __future__ import annotations

import json
import socket
from dataclasses import dataclass
from typing import Any

from zbot.launch.control.control_server import FOLDER
from zbot.launch.errors import LaunchControlError
from zbot.text.json_reader import JsonError, read_json_object
from zbot.transport.membership import folder
from zbot.transport.process_facts import process_space
from zbot.transport.program_file import program_documents

_PATIENCE_S = 2.0
_MOST_BYTES = 4_000_000


@dataclass(frozen=True)
class RunningLaunch:
    """A launch of this user on this machine."""

    pid: int
    domain: int
    port: int
    token: str

    def ask(self, op: str, **words: object) -> dict[str, Any]:
        """Send a request, and return the answer. Call it in a thread, because it may wait for 2 s.

        Args:
            op: `look`, `output`, `stop`, `restart` or `end`.
            words: `label` of a process, and for `output` the number of the last known line as
                `after`.

        Raises:
            LaunchControlError: The launch has ended, or refuses the request.
        """
        request = {"token": self.token, "op": op, **words}
        try:
            answer = read_json_object(
                self._exchange(json.dumps(request)).decode("utf-8", "replace")
            )
        except (OSError, JsonError):
            raise LaunchControlError("the launch has ended") from None
        if "error" in answer:
            raise LaunchControlError(str(answer["error"]))
        return answer

    def _exchange(self, request: str) -> bytes:
        with socket.create_connection(("127.0.0.1", self.port), _PATIENCE_S) as connection:
            connection.sendall(request.encode() + b"\n")
            answer = b""
            while len(answer) < _MOST_BYTES and (data := connection.recv(65_536)):
                answer += data
        return answer


def running_launches(domain: int) -> list[RunningLaunch]:
    """Return the launches of this user in a domain on this machine, the oldest first."""
    here = process_space()
    found = [
        RunningLaunch(document["pid"], domain, document["port"], str(document["token"]))
        for document in program_documents(folder() / FOLDER)
        if document.get("space") == here
        and document.get("domain") == domain
        and {"pid", "port", "token"} <= document.keys()
    ]
    return sorted(found, key=lambda launch: launch.pid)
