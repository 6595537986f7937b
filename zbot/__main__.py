"""`python -m zbot` is the `zbot` command; `python -m zbot program.py` is `zbot run program.py`."""

from __future__ import annotations

import runpy
import sys


def main() -> None:
    """Hand the words over to the command, which is a package of its own."""
    if len(sys.argv) > 1 and sys.argv[1].endswith(".py"):
        sys.argv.insert(1, "run")
    # The library never imports the command, so that it can do without: this asks for it by name.
    runpy.run_module("zbot_cli", run_name="__main__", alter_sys=True)


if __name__ == "__main__":
    main()
