"""Program that imports all modules as on Windows: without what only POSIX has."""

from __future__ import annotations

import importlib
import os
import pkgutil
import signal
import sys
import types
from typing import Any

# These look at the platform when they are loaded. They get the real one.
LOADED_BEFORE = [
    *("asyncio", "concurrent.futures.process", "importlib.metadata", "importlib.resources"),
    *("logging.handlers", "multiprocessing.shared_memory", "ssl", "subprocess", "tempfile"),
    *("uuid", "webbrowser"),
    *("mcap", "nicegui", "numpy", "psutil", "rosbags", "typer.main", "uvicorn", "zenoh"),
]
MODULES = ["curses", "fcntl", "grp", "pty", "pwd", "readline", "resource", "termios", "tty"]
SIGNALS = ["ALRM", "CHLD", "CONT", "HUP", "KILL", "PIPE", "QUIT", "STOP", "TSTP", "USR1", "USR2"]
SIGNAL_FUNCTIONS = ["pthread_kill", "pthread_sigmask", "setitimer"]
OS_FUNCTIONS = [
    *("fork", "getgroups", "getloadavg", "getpgid", "geteuid", "getuid", "killpg", "mkfifo"),
    *("openpty", "setsid", "uname"),
]
CONSOLE = ["getwch", "kbhit", "locking", "LK_LOCK", "LK_NBLCK", "LK_RLCK", "LK_UNLCK"]
PACKAGES = ["zbot", "zbot_cli", "zbot_nodes"]
NOT_STARTED_THERE = {"zbot.launch.watchdog"}


def load_libraries() -> None:
    for name in LOADED_BEFORE:
        try:
            importlib.import_module(name)
        except ImportError:
            print(f"without {name}")


def pretend() -> None:
    modules: dict[str, Any] = sys.modules
    sys.platform = "win32"
    for name in MODULES:
        modules[name] = None  # `import` then raises ImportError
    for name in (*(f"SIG{short}" for short in SIGNALS), *SIGNAL_FUNCTIONS):
        delattr(signal, name)
    for name in OS_FUNCTIONS:
        delattr(os, name)
    console = types.ModuleType("msvcrt")
    for name in CONSOLE:
        setattr(console, name, None)
    sys.modules["msvcrt"] = console


def main() -> None:
    load_libraries()
    pretend()
    count = 0
    for package in map(importlib.import_module, PACKAGES):
        for module in pkgutil.walk_packages(package.__path__, f"{package.__name__}."):
            is_program = module.name.endswith("__main__") or module.name in NOT_STARTED_THERE
            if not is_program and ".stubs" not in module.name:
                importlib.import_module(module.name)
                count += 1
    print(f"{count} modules")


main()
