"""Who is at the keyboard, as far as git or the system knows."""

from __future__ import annotations

import re
import shutil
import subprocess


def full_name() -> str:
    """Return the name that git commits under, else the login name."""
    return _git("user.name") or _login_name()


def email_address(name: str) -> str:
    """Return the address that git commits under, else one that asks to be replaced."""
    return _git("user.email") or f"{re.sub(r'[^a-z0-9]+', '.', name.lower()).strip('.')}@todo.todo"


def _login_name() -> str:
    import getpass  # noqa: PLC0415 - git knows most people

    try:
        return getpass.getuser()
    except (ImportError, KeyError, OSError):  # a container's user without an entry
        return "user"


def _git(key: str) -> str:
    program = shutil.which("git")
    if program is None:
        return ""
    done = subprocess.run(  # noqa: S603 - git itself, with words of ours
        [program, "config", key], capture_output=True, encoding="utf-8", check=False
    )
    return done.stdout.strip()
