"""Name and e-mail address of the user, from git or the system."""

from __future__ import annotations

import re
import shutil
import subprocess


def full_name() -> str:
    """Return the name from git's configuration, or the login name if git has no name."""
    return _git("user.name") or _login_name()


def email_address(name: str) -> str:
    """Return the address from git's configuration, or a placeholder such as `ana@todo.todo`."""
    return _git("user.email") or f"{re.sub(r'[^a-z0-9]+', '.', name.lower()).strip('.')}@todo.todo"


def _login_name() -> str:
    import getpass  # noqa: PLC0415 - needed only without a name in git

    try:
        return getpass.getuser()
    except (ImportError, KeyError, OSError):  # a container's user may not be in /etc/passwd
        return "user"


def _git(key: str) -> str:
    program = shutil.which("git")
    if program is None:
        return ""
    done = subprocess.run(  # noqa: S603 - git itself, with words of ours
        [program, "config", key], capture_output=True, encoding="utf-8", check=False
    )
    return done.stdout.strip()
