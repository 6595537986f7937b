"""Access rules of the teacher's hub, which forwards messages between the laptops of a class.

The functions return paths and values of Zenoh's configuration, in the form that
`SessionConfig.build` takes. The rules use Zenoh's access control and allow nothing by default. They
identify a student by the user name with which the laptop's hub logs in. So a student's programs
cannot act as another user. The room `zbot.classroom` adds the id of the laptop's hub.

A class has these key spaces. `<n>` is the student's domain:

| keys | student `<n>` | teacher |
|---|---|---|
| `<n>/**`, `@zbot/<n>/**` | all | all |
| `class/**`, `@zbot/class/**` | read (all if the space is open) | all |
| `class/<robot>/**` | all, while the student drives this robot | all |
| `@class/student/<n>/**` | write | all |
| `@class/teacher/**` | read | all |
| `@class/lobby/**` | query | all |
| all other keys, also the admin space `@/**` | nothing | all |

"Write" means to publish, answer queries and declare tokens. "Read" means to subscribe, query and
watch tokens.

A laptop that has not joined connects as the user `lobby`, whose password is public. This user may
only query the lobby keys. The class answers these queries: it checks the PIN (`zbot.security.pin`)
and returns a secret.

Zenoh does not forward a declaration if its key expression includes keys that the receiver's rules
do not allow. So the teacher's tools subscribe and query each domain (`17/**`), never `**`.

Zenoh reads the rules when a session opens. So the hub's session must be reopened after a change of
the rules.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from zbot.security.errors import SecurityError
from zbot.security.secret import Secret

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping
    from pathlib import Path

TEACHER = "teacher"  #: user name of the teacher's own programs
SHARED_SPACE = "class"  #: replaces the domain: the key of `/class/demo` is `class/demo`
STUDENT_SPACE = "@class/student"  #: facts about laptops: `@class/student/17/...`
TEACHER_SPACE = "@class/teacher"  #: the teacher's notices to all students

LOBBY_SPACE = "@class/lobby"  #: queries of laptops that want to join
LOBBY = "lobby"  #: user name of laptops that have not joined
LOBBY_SECRET = Secret("lobby")  #: not secret; it exists only because Zenoh requires a password

#: Maximum size of a message between laptops (bytes): two uncompressed 4K images.
MAX_MESSAGE_SIZE = 64 * 1024 * 1024
#: Maximum number of open sessions. A class has a few hundred, but an attacker may open many more.
MAX_SESSIONS = 4000
#: Maximum number of half-open connections. A class may reconnect while an attacker opens 1,000.
ACCEPT_PENDING = 2000
#: Time (ms) after which a half-open connection is closed. A laptop usually needs 10 ms to open a
#: connection completely, and 2 s if a round trip takes 0.6 s and a packet is lost.
ACCEPT_TIMEOUT_MS = 3000

# Zenoh assigns each connection to a region. All connections of the hub belong to the region below
# the hub ("south"), where a router gets only the keys that it may read. In the hub's own region,
# Zenoh ignores the access rules and sends all keys to all routers. A laptop there would get the
# name of every topic and node of the class.
_REGIONS: dict[str, Any] = {"south": [{}]}

_WRITE_MESSAGES = ("put", "delete", "reply", "declare_queryable", "liveliness_token")
_READ_MESSAGES = (
    "declare_subscriber",
    "query",
    "liveliness_query",
    "declare_liveliness_subscriber",
)
_ALL_KEYS = ("**", "**/@adv/**", "@/**", "@zbot/**", "@class/**", "@hub/**", "@ros2_lv/**")


def user_name_error(name: str) -> SecurityError:
    """Return the error that a user name is reserved, too long, or not for Zenoh's password file."""
    return SecurityError(
        f"{name!r} is not a user name: use up to 64 letters, digits, '.', '_' and '-' "
        f"(and neither {TEACHER!r} nor {LOBBY!r})"
    )


@dataclass(frozen=True)
class Share:
    """Right of a student to read another student's domain.

    Attributes:
        domain: The domain that is shared.
        reader: User name of the student who may read it.
    """

    domain: int
    reader: str


def teacher_access(
    students: Mapping[str, int],
    *,
    shared_is_open: bool = False,
    shares: Iterable[Share] = (),
    drivers: Mapping[str, str] | None = None,
) -> dict[str, Any]:
    """Return the configuration of the teacher's hub. Endpoints and credentials are not included.

    Args:
        students: The domain of each user name.
        shared_is_open: Whether students may publish in the shared space too.
        shares: The domains that the teacher has shared between students.
        drivers: The robot that each user drives now. The keys are user names.

    Returns:
        Zenoh's configuration paths, each with its value.

    Raises:
        SecurityError: A user name is invalid.
    """
    policies = [
        ([TEACHER], [_full_rule(TEACHER, _ALL_KEYS)]),
        ([LOBBY], _query_rules(LOBBY)),
        ([*students], _common_rules(shared_is_open)),
    ]
    given = list(shares)
    for user, domain in students.items():
        if user in {TEACHER, LOBBY}:
            raise user_name_error(user)
        rules = _student_rules(_checked(user), domain)
        shared = sorted({share.domain for share in given if share.reader == user})
        for number in shared:
            rules += _read_rules(f"student {user} shared {number}", _space(str(number)))
        robot = (drivers or {}).get(user)
        if robot:
            rules += _write_rules(f"student {user} drives", _robot_space(robot))
        policies.append(([user], rules))
    return {
        "access_control": {
            "enabled": True,
            "default_permission": "deny",
            "rules": [rule for _, rules in policies for rule in rules],
            "subjects": [{"id": user, "usernames": [user]} for user in (TEACHER, LOBBY, *students)],
            "policies": [
                {"subjects": users, "rules": [rule["id"] for rule in rules]}
                for users, rules in policies
                if users
            ],
        },
        "gateway": _REGIONS,
        **limits(),
    }


def limits() -> dict[str, Any]:
    """Return the limits that protect a hub from large messages and from too many connections."""
    return {
        "transport/link/rx/max_message_size": MAX_MESSAGE_SIZE,
        "transport/unicast/max_sessions": MAX_SESSIONS,
        "transport/unicast/accept_pending": ACCEPT_PENDING,
        "transport/unicast/accept_timeout": ACCEPT_TIMEOUT_MS,
    }


def credentials(user: str, secret: Secret, accepted: Path | None = None) -> dict[str, Any]:
    """Return the configuration of a session that logs in with a user name.

    If a machine has joined with a PIN, all its sessions need this configuration, also the sessions
    of its nodes. A session with a user name refuses sessions without a user name.

    Args:
        user: The session's user name.
        secret: The user's password.
        accepted: File of the users that the session accepts (`accepted_users`). Only a session
            that listens needs the file.

    Raises:
        SecurityError: The user name is invalid.
    """
    path = "transport/auth/usrpwd"
    found = {f"{path}/user": _checked(user), f"{path}/password": secret.reveal()}
    if accepted is not None:
        found[f"{path}/dictionary_file"] = str(accepted)
    return found


def accepted_users(users: Mapping[str, Secret]) -> bytes:
    """Return the content of a file of the users that a session accepts (see `write_private`).

    Raises:
        SecurityError: A user name is invalid.
    """
    lines = (f"{_checked(user)}:{secret.reveal()}\n" for user, secret in users.items())
    return "".join(lines).encode()


def _checked(user: str) -> str:
    is_plain = user.isascii() and all(char.isalnum() or char in "._-" for char in user)
    if not is_plain or not 1 <= len(user) <= 64:
        raise user_name_error(user)
    return user


def _common_rules(shared_is_open: bool) -> list[dict[str, Any]]:
    """Return the rules that are the same for all students.

    Zenoh needs about 70 bytes for each character of the rules while it reads them: 60 MB if each
    student had rules of its own for these keys, 26 MB with this function, and 15 MB because
    `_full_rule` also replaces four rules.
    """
    shared = _space(SHARED_SPACE)
    rules = [
        *_read_rules("students shared", shared),
        *_read_rules("students teacher", (f"{TEACHER_SPACE}/**",)),
        *_query_rules("students"),
    ]
    return rules + (_write_rules("students shared", shared) if shared_is_open else [])


def _student_rules(user: str, domain: int) -> list[dict[str, Any]]:
    return [
        _full_rule(f"{user} own", _space(str(domain))),
        *_write_rules(f"{user} itself", (f"{STUDENT_SPACE}/{domain}/**",)),
    ]


def _space(first_chunk: str) -> tuple[str, ...]:
    # The caches of transient local publishers (zenoh.ext) need the second key, because `**` does
    # not match a chunk that begins with `@`.
    return (f"{first_chunk}/**", f"{first_chunk}/**/@adv/**", f"@zbot/{first_chunk}/**")


def _robot_space(robot: str) -> tuple[str, ...]:
    # In a token, the name of a topic is one chunk, `%class%robot%cmd_vel`. The chunks before this
    # chunk are ids, a kind, an enclave, a namespace and a node.
    keys = f"{SHARED_SPACE}/{robot}/**", f"{SHARED_SPACE}/{robot}/**/@adv/**"
    return (*keys, f"@zbot/{SHARED_SPACE}/*/*/*/*/*/*/*/%{SHARED_SPACE}%{robot}%$*/**")


def _full_rule(name: str, keys: tuple[str, ...]) -> dict[str, Any]:
    """Return a rule that does the same as `_read_rules` and `_write_rules`."""
    return _rule(name, "ingress egress", _READ_MESSAGES + _WRITE_MESSAGES, keys)


def _write_rules(name: str, keys: tuple[str, ...]) -> list[dict[str, Any]]:
    return [
        _rule(f"{name}: write", "ingress", _WRITE_MESSAGES, keys),
        _rule(f"{name}: write (other side)", "egress", _READ_MESSAGES, keys),
    ]


def _read_rules(name: str, keys: tuple[str, ...]) -> list[dict[str, Any]]:
    return [
        _rule(f"{name}: read", "ingress", _READ_MESSAGES, keys),
        _rule(f"{name}: read (other side)", "egress", _WRITE_MESSAGES, keys),
    ]


def _query_rules(name: str) -> list[dict[str, Any]]:
    keys = (f"{LOBBY_SPACE}/**",)
    return [
        _rule(f"{name} lobby: query", "ingress", ("query",), keys),
        _rule(f"{name} lobby: reply", "egress", ("reply", "declare_queryable"), keys),
    ]


def _rule(
    name: str, flows: str, messages: tuple[str, ...], keys: tuple[str, ...]
) -> dict[str, Any]:
    return {
        "id": name,
        "permission": "allow",
        "flows": flows.split(),
        "messages": list(messages),
        "key_exprs": list(keys),
    }
