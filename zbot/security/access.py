"""The rules that the teacher's hub enforces: which student's messages may pass, and which may not.

Everything here is pure: users and domains in, paths and values of Zenoh's configuration out, in the
form that `SessionConfig.build` takes. The rules are Zenoh's access control with nothing allowed by
default; a student is the user name with which a hub was let in, so what a student's programs claim
to be does not matter.

The key spaces of a class, in which `<n>` is the student's domain:

| keys | student `<n>` | teacher |
|---|---|---|
| `<n>/**`, `@zbot/<n>/**` | all | all |
| `class/**`, `@zbot/class/**` | hears; all if the space is open | all |
| `@class/student/<n>/**` | tells | all |
| `@class/teacher/**` | hears | all |
| `@class/lobby/**` | asks | all |
| everything else, the admin space `@/**` included | nothing | all |

Everybody who has not joined yet is the user `lobby`, whose password is no secret, and who may ask
in the lobby and nothing else: there a PIN is checked (`zbot.security.pin`) and a secret handed out.

*Tells* means: publishes, serves, declares tokens. *Hears* means: subscribes, calls, sees tokens.

Zenoh compares a declaration as a whole: one that is wider than what its partner may hear does not
reach it. So the teacher's tools subscribe and query per domain (`17/**`), never `**`. Zenoh reads
the rules when a session opens: whoever changes them reopens the hub's session.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from zbot.errors import SetupError
from zbot.security.secret import Secret

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping
    from pathlib import Path

TEACHER = "teacher"  #: user name of the teacher's own programs
SHARED_SPACE = "class"  #: in a key, this stands where a domain would: `/class/demo` is `class/demo`
STUDENT_SPACE = "@class/student"  #: what students tell of themselves: `@class/student/17/...`
TEACHER_SPACE = "@class/teacher"  #: what the teacher tells everybody

LOBBY_SPACE = "@class/lobby"  #: where who wants to join asks the hub
LOBBY = "lobby"  #: user name of whoever has not joined yet
LOBBY_SECRET = Secret("lobby")  #: known to all: Zenoh wants a password from each user

#: A message between laptops is refused above this size (bytes): two uncompressed 4K images.
MAX_MESSAGE_SIZE = 64 * 1024 * 1024
#: How many sessions may be open: a class has a few hundred, whoever else comes may have many.
MAX_SESSIONS = 4000
#: How many connections may be half open: a class that reconnects, and 1,000 of a troublemaker.
ACCEPT_PENDING = 2000
#: How long (ms) one may stay half open; honest ones take 10 ms, on bad Wi-Fi 1 s.
ACCEPT_TIMEOUT_MS = 3000

# Whoever connects is below the hub ("south") rather than beside it. Zenoh sends a router beside it
# the names of all keys, as they say nothing of who may use them: every topic and node of the class
# to every laptop. One below gets the names of what it is told, which the rules decide.
_REGIONS: dict[str, Any] = {"south": [{}]}

_SAYING = ("put", "delete", "reply", "declare_queryable", "liveliness_token")
_ASKING = ("declare_subscriber", "query", "liveliness_query", "declare_liveliness_subscriber")
_EVERYWHERE = ("**", "**/@adv/**", "@/**", "@zbot/**", "@class/**", "@hub/**", "@ros2_lv/**")


class UserNameError(SetupError, ValueError):
    """A user name has characters that Zenoh's password file cannot hold."""

    def __init__(self, name: str) -> None:
        self.name = name
        super().__init__(
            f"{name!r} is no user name: use up to 64 letters, digits, '.', '_' and '-' "
            f"(and neither {TEACHER!r} nor {LOBBY!r})"
        )


@dataclass(frozen=True)
class Share:
    """One student's domain, opened for another student to hear.

    Attributes:
        domain: Whose topics and services.
        reader: User name of the student who may hear them.
    """

    domain: int
    reader: str


def teacher_access(
    students: Mapping[str, int],
    *,
    shared_is_open: bool = False,
    shares: Iterable[Share] = (),
) -> dict[str, Any]:
    """Return what the teacher's hub is configured with, besides its endpoints and credentials.

    Args:
        students: User names, each with its domain.
        shared_is_open: Whether students may publish in the shared space too.
        shares: What the teacher has opened between students.

    Returns:
        Zenoh's configuration paths, each with its value.

    Raises:
        UserNameError: A user's name cannot be one.
    """
    policies = [
        (TEACHER, _tells(TEACHER, _EVERYWHERE) + _hears(TEACHER, _EVERYWHERE)),
        (LOBBY, _asks(LOBBY)),
    ]
    opened = list(shares)
    for user, domain in students.items():
        if user in {TEACHER, LOBBY}:
            raise UserNameError(user)
        rules = _student_rules(_checked(user), domain, shared_is_open)
        heard = sorted({share.domain for share in opened if share.reader == user})
        for number in heard:
            rules += _hears(f"student {user} shared {number}", _space(str(number)))
        policies.append((user, rules))
    return {
        "access_control": {
            "enabled": True,
            "default_permission": "deny",
            "rules": [rule for _, rules in policies for rule in rules],
            "subjects": [{"id": user, "usernames": [user]} for user, _ in policies],
            "policies": [
                {"subjects": [user], "rules": [rule["id"] for rule in rules]}
                for user, rules in policies
            ],
        },
        "gateway": _REGIONS,
        **limits(),
    }


def limits() -> dict[str, Any]:
    """Return what keeps a hub up when somebody sends too much or opens too many connections."""
    return {
        "transport/link/rx/max_message_size": MAX_MESSAGE_SIZE,
        "transport/unicast/max_sessions": MAX_SESSIONS,
        "transport/unicast/accept_pending": ACCEPT_PENDING,
        "transport/unicast/accept_timeout": ACCEPT_TIMEOUT_MS,
    }


def credentials(user: str, secret: Secret, accepted: Path | None = None) -> dict[str, Any]:
    """Return the configuration of a session that names itself.

    Every session of a machine that has joined with a PIN needs it, its nodes' too: once a session
    has a user, it refuses partners that have none.

    Args:
        user: Who the session is.
        secret: Its password.
        accepted: The file of those it lets in (`accepted_users`); a session that listens needs one.

    Raises:
        UserNameError: The name cannot be one.
    """
    path = "transport/auth/usrpwd"
    found = {f"{path}/user": _checked(user), f"{path}/password": secret.reveal()}
    if accepted is not None:
        found[f"{path}/dictionary_file"] = str(accepted)
    return found


def accepted_users(users: Mapping[str, Secret]) -> bytes:
    """Return the content of the file of users whom a session lets in (see `write_private`).

    Raises:
        UserNameError: A user's name cannot be one.
    """
    lines = (f"{_checked(user)}:{secret.reveal()}\n" for user, secret in users.items())
    return "".join(lines).encode()


def _checked(user: str) -> str:
    is_plain = user.isascii() and all(char.isalnum() or char in "._-" for char in user)
    if not is_plain or not 1 <= len(user) <= 64:
        raise UserNameError(user)
    return user


def _student_rules(user: str, domain: int, shared_is_open: bool) -> list[dict[str, Any]]:
    name = f"student {user}"
    own, shared = _space(str(domain)), _space(SHARED_SPACE)
    rules = [
        *_tells(f"{name} own", own),
        *_hears(f"{name} own", own),
        *_hears(f"{name} shared", shared),
        *_tells(f"{name} itself", (f"{STUDENT_SPACE}/{domain}/**",)),
        *_hears(f"{name} teacher", (f"{TEACHER_SPACE}/**",)),
        *_asks(name),
    ]
    return rules + (_tells(f"{name} shared", shared) if shared_is_open else [])


def _space(first_chunk: str) -> tuple[str, ...]:
    # The second holds what transient local publishers answer latecomers with (zenoh.ext); `**` does
    # not reach a chunk that begins with `@`.
    return (f"{first_chunk}/**", f"{first_chunk}/**/@adv/**", f"@zbot/{first_chunk}/**")


def _tells(name: str, keys: tuple[str, ...]) -> list[dict[str, Any]]:
    return [
        _rule(f"{name}: says", "ingress", _SAYING, keys),
        _rule(f"{name}: is asked", "egress", _ASKING, keys),
    ]


def _hears(name: str, keys: tuple[str, ...]) -> list[dict[str, Any]]:
    return [
        _rule(f"{name}: asks", "ingress", _ASKING, keys),
        _rule(f"{name}: is told", "egress", _SAYING, keys),
    ]


def _asks(name: str) -> list[dict[str, Any]]:
    keys = (f"{LOBBY_SPACE}/**",)
    return [
        _rule(f"{name} lobby: asks", "ingress", ("query",), keys),
        _rule(f"{name} lobby: is told", "egress", ("reply", "declare_queryable"), keys),
    ]


def _rule(name: str, flow: str, messages: tuple[str, ...], keys: tuple[str, ...]) -> dict[str, Any]:
    return {
        "id": name,
        "permission": "allow",
        "flows": [flow],
        "messages": list(messages),
        "key_exprs": list(keys),
    }
