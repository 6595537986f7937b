"""`python -m zbot` is the `zbot` command; `python -m zbot program.py` is `zbot run program.py`."""

from __future__ import annotations

import runpy
import sys


def main() -> None:
    """Run the package `zbot_cli`, which is the command, with the arguments of this process."""
    if len(sys.argv) > 1 and sys.argv[1].endswith(".py"):
        sys.argv.insert(1, "run")
    # The library does not import the command, because it must also work without the command. So the
    # command is run by its name.
    runpy.run_module("zbot_cli", run_name="__main__", alter_sys=True)


if __name__ == "__main__":
    main()
