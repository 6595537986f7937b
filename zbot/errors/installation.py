"""Commands that start this Python: to install a package, and in place of the command `zbot`."""

from __future__ import annotations

import os
import sys


def pip_install(package: str) -> str:
    """Return the command for a terminal, e.g. `python -m pip install "zbot[bag]"`."""
    word = package if package.replace("-", "").replace("_", "").isalnum() else f'"{package}"'
    return f"{_python()} -m pip install {word}"


def with_typed_command(text: str) -> str:
    """Return a text with `python -m zbot` in place of `zbot` if the user typed that.

    On locked-down machines, the command `zbot` is refused, and a text must not name it.

    Args:
        text: A text with commands in quotes, e.g. "`zbot doctor` says more".
    """
    words = sys.orig_argv
    typed = words[words.index("-m") + 1 :][:1] if "-m" in words else []
    if typed != ["zbot"] or "zbot " not in text:
        return text
    import re  # noqa: PLC0415 - only for errors

    return re.sub(r"(?<=[`'])zbot (?=[a-z-])", lambda _: f"{_python()} -m zbot ", text)


def _python() -> str:
    """Return the word that starts this Python: `python`, `python3` or its path.

    A terminal may find the Python of another environment, e.g. if the environment of this process
    is not activated.
    """
    import shlex  # noqa: PLC0415 - only for the errors of missing packages
    import shutil  # noqa: PLC0415 - as above

    for name in ("python", "python3"):
        found = shutil.which(name)
        if found and _place(found) == _place(sys.executable):
            return name
    if os.name == "nt":
        return f'& "{sys.executable}"' if " " in sys.executable else sys.executable
    return shlex.quote(sys.executable or "python")


def _place(program: str) -> tuple[str, str]:
    """Return the folder of a program, which is that of its environment, and its real file."""
    return os.path.realpath(os.path.dirname(program)), os.path.realpath(program)  # noqa: PTH120
