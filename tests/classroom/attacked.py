"""A real class on this machine, with the commands that teacher and students type."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from tests.classroom.talk import HERE, Talk, answers, dialling, free_port, open_session
from tests.conftest import Program, allowed, wait_until
from zbot.classroom.hub.link import dialled_identity
from zbot.classroom.keys import ADMISSION_KEY, COMMAND_KEY, here_key
from zbot.security.access import LOBBY, LOBBY_SECRET, accepted_users, credentials
from zbot.security.pin import PinClient
from zbot.security.secret import Secret

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path

    import zenoh

PIN = "471100"
_PREFIXES = ("ZBOT_", "ROS_", "RCUTILS_", "ZENOH_", "XDG_")


@dataclass(frozen=True)
class Finished:
    """How a command ended."""

    code: int
    out: str
    err: str


def pin_client(session: zenoh.Session, pin: str) -> PinClient:
    """Return the laptop's side of a PIN check, for a laptop that has dialled the class."""
    return PinClient(Secret(pin), "attacked", dialled_identity(session))


class Computer:
    """A folder and a port of its own: all that tells one user's zbot from another's."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.port = free_port()
        folder.mkdir()

    def run(self, *words: str, stdin: str = "", **env: str) -> Finished:
        """Run a command; it must not end in a traceback."""
        done = subprocess.run(
            [sys.executable, "-m", "zbot_cli", *words],
            input=stdin,
            env={**self._environment(), **env},
            cwd=self.folder,
            capture_output=True,
            encoding="utf-8",
            timeout=allowed(60),
            check=False,
        )
        assert "Traceback" not in done.stderr, done.stderr
        return Finished(done.returncode, done.stdout, done.stderr)

    def _environment(self) -> dict[str, str]:
        kept = {name: value for name, value in os.environ.items() if not name.startswith(_PREFIXES)}
        own = {"XDG_CONFIG_HOME": str(self.folder), "ZBOT_HUB_PORT": str(self.port)}
        return {**kept, **own, "PYTHONUNBUFFERED": "1"}

    @contextmanager
    def background(self, *words: str) -> Iterator[Program]:
        """Run a command for the length of a block, and end it with Ctrl-C."""
        command = [sys.executable, "-m", "zbot_cli", *words]
        program = Program(command, self.folder, self._environment())
        try:
            yield program
        finally:
            program.stop()

    def do(self, *words: str, **env: str) -> str:
        """Run a command that has to work; return what it printed."""
        done = self.run(*words, **env)
        assert done.code == 0, done
        return done.out

    @property
    def has_joined(self) -> bool:
        """Whether this user takes part in something."""
        return self._membership_path.exists()

    @property
    def membership(self) -> dict[str, Any]:
        """What this user has joined, with the secret."""
        found: dict[str, Any] = json.loads(self._membership_path.read_text())
        return found

    @property
    def _membership_path(self) -> Path:
        return self.folder / "zbot" / "membership.json"

    @property
    def credentials(self) -> dict[str, Any]:
        """What this user's sessions introduce themselves with."""
        known = self.membership
        return credentials(known["user"], Secret(known["secret"]))

    @property
    def identity(self) -> dict[str, Any]:
        """What this user's hub introduces itself with at the class."""
        return {**self.credentials, "id": self.membership["hub_id"]}

    @contextmanager
    def without_hub(self) -> Iterator[None]:
        """End this user's hub for the length of a block."""
        state = json.loads((self.folder / "zbot" / "hub.json").read_text())
        os.kill(state["pid"], getattr(signal, "SIGKILL", signal.SIGTERM))
        try:
            yield
        finally:
            self.do("join")


class AttackedClass:
    """A class with a PIN, Ana (17), and Ben (18), who is the attacker."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._sessions: list[zenoh.Session] = []
        self._computers: list[Computer] = []
        self.teacher = self.computer("teacher")
        self.port = self.teacher.port
        self.teacher.do(
            "class", "start", "attacked", "--pin", "--port", str(self.port), ZBOT_PIN=PIN
        )
        self.ana = self.student("ana", 17)
        self.ben = self.student("ben", 18)
        self.teacher_session = self.open(dialling(self.port, self.teacher.credentials))
        self.talk = Talk(self.teacher_session)
        self.honest = self.talk.add(self.open(dialling(self.ana.port, self.ana.credentials)), 17)

    def computer(self, name: str) -> Computer:
        """Return one more computer, of somebody who has joined nothing."""
        self._computers.append(Computer(self._folder / name))
        return self._computers[-1]

    def student(self, name: str, number: int) -> Computer:
        """Return one more computer, which has joined."""
        joining = self.computer(name)
        words = ("join", f"{HERE}:{self.port}", "--name", name.title(), "--number", str(number))
        joining.do(*words, ZBOT_PIN=PIN)
        return joining

    def open(self, paths: dict[str, Any]) -> zenoh.Session:
        """Open a plain Zenoh session, which is closed at the end at the latest."""
        self._sessions.append(open_session(paths))
        return self._sessions[-1]

    @contextmanager
    def as_ben(self, *, directly: bool) -> Iterator[zenoh.Session]:
        """Open a session of Ben: in the place of his hub, or behind it."""
        with ExitStack() as stack:
            known = dialling(self.ben.port, self.ben.credentials)
            if directly:
                stack.enter_context(self.ben.without_hub())
                known = dialling(self.port, self.ben.identity)
            session = stack.enter_context(open_session(known))
            here = session.liveliness().declare_token(here_key(18)) if directly else None
            yield self.talk.add(session, 18)
            if here is not None:
                here.undeclare()
            self.talk.remove(session)

    @contextmanager
    def as_guest_of_ben(self) -> Iterator[zenoh.Session]:
        """Open a session behind a router that Ben has configured himself, in the place of his hub.

        It has Ben's credentials and no access rules, accepts a user of its own, listens on all
        networks and dials all hubs that it knows.
        """
        port, guest = free_port(), Secret("guest")
        accepted = self.ben.folder / "guests"
        accepted.write_bytes(accepted_users({"guest": guest}))
        own = {
            "mode": "router",
            "listen/endpoints": [f"tcp/0.0.0.0:{port}"],
            "connect/endpoints": [f"tcp/{HERE}:{port}" for port in (self.port, self.ana.port)],
            "connect/timeout_ms": -1,
            "connect/exit_on_failure": False,
            "transport/auth/usrpwd/dictionary_file": str(accepted),
            **self.ben.identity,
        }
        as_guest = dialling(port, credentials("guest", guest))
        with (
            self.ben.without_hub(),
            open_session(own) as router,
            open_session(as_guest) as session,
        ):
            self.talk.add(router, 18)
            yield self.talk.add(session, 18)
            self.talk.remove(session)
            self.talk.remove(router)

    @contextmanager
    def as_raw_client(self) -> Iterator[zenoh.Session]:
        """Join as number 19 with a program that is not zbot, and declare its token."""
        with self.as_lobby_user() as lobby_user:
            request = {"machine": "raw", "host": "raw", "name": "Raw", "number": 19}
            client = pin_client(lobby_user, PIN)
            challenge = self.ask_admission(lobby_user, {"op": "enrol", **client.hello()})
            claim = {"op": "claim", **client.claim(challenge, request)}
            given = client.opened(self.ask_admission(lobby_user, claim))
        known = credentials(given["user"], Secret(given["secret"]))
        with open_session(dialling(self.port, {**known, "id": given["hub_id"]})) as session:
            here = session.liveliness().declare_token(here_key(19))
            yield self.talk.add(session, 19)
            self.talk.remove(session)
            here.undeclare()

    @contextmanager
    def as_lobby_user(self) -> Iterator[zenoh.Session]:
        """Open a session of a user who has not joined."""
        with open_session(dialling(self.port, credentials(LOBBY, LOBBY_SECRET))) as session:
            assert wait_until(lambda: answers(session, ADMISSION_KEY))
            yield session

    @staticmethod
    def ask_admission(session: zenoh.Session, question: dict[str, Any]) -> dict[str, Any]:
        """Query the admission service of the class; return its reply, empty if there is none."""
        replies = session.get(ADMISSION_KEY, payload=json.dumps(question), timeout=10)
        told = [reply.ok.payload.to_bytes() for reply in replies if reply.ok]
        answer: dict[str, Any] = json.loads(told[0]) if told else {}
        return answer

    def listed(self) -> dict[int, dict[str, Any]]:
        """Return what the teacher's list says, by number."""
        told: list[dict[str, Any]] = []

        def is_told() -> bool:  # at once, unless the hub is being opened anew
            question = json.dumps({"op": "list"})
            replies = self.teacher_session.get(COMMAND_KEY, payload=question, timeout=10)
            told.extend(json.loads(reply.ok.payload.to_bytes()) for reply in replies if reply.ok)
            return bool(told)

        assert wait_until(is_told, 20)
        return {student["number"]: student for student in told[0]["students"]}

    def check_honest_work(self) -> None:
        """Check that Ana and the teacher can still work."""
        assert wait_until(lambda: self.talk.hears(self.teacher_session, self.honest, "17/work"), 20)
        assert self.talk.hears(self.honest, self.teacher_session, "17/work")
        assert self.talk.reaches(self.teacher_session, self.honest, "17/service")
        assert self.listed()[17]["here"]

    def close(self) -> None:
        """End everything."""
        for session in reversed(self._sessions):
            session.close()
        for computer in reversed(self._computers):
            if computer.has_joined:
                computer.run("leave", "--yes")
