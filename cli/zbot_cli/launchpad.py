"""What a child of `zbot run` begins with: zbot's names become importable, then the program runs.

Run: python -m zbot_cli.launchpad (MODULE:FUNCTION | PATH) FOLDER [ARGS]...
"""

from __future__ import annotations

import importlib
import os
import runpy
import sys
from pathlib import Path


def main() -> None:
    """Run the program that the command line names, as Python itself would."""
    from zbot import signals  # noqa: PLC0415 - Ctrl-C may come from now on

    signals.install(signals.SignalHandlerOptions.SIGINT)
    _, target, folder, *arguments = sys.argv
    if folder:
        sys.path.insert(0, folder)
    if target.endswith(".py") or os.sep in target:
        sys.path.insert(0, str(Path(target).resolve().parent))
        sys.argv = [target, *arguments]
        runpy.run_path(target, run_name="__main__")
        return
    module_name, _, function_name = target.partition(":")
    sys.argv = [module_name.rpartition(".")[2], *arguments]
    function = importlib.import_module(module_name.strip())
    for part in function_name.split(" ")[0].split("."):
        function = getattr(function, part)
    sys.exit(function())  # type: ignore[operator]


if __name__ == "__main__":
    main()
