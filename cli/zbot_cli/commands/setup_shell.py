"""`zbot setup-shell SHELL`: prints shell functions named `ros2`, `colcon` etc., which run zbot.

They are functions and not programs, because a program named `ros2` in the folder of zbot would hide
the `ros2` of a real ROS 2. A function can look for the real `ros2` at each call.
"""

from __future__ import annotations

from typing import Annotated

import typer

from zbot.package.bundled_nodes import BUNDLED_PROGRAMS
from zbot_cli.output.listing import new_app

app = new_app("Make ros2, colcon and rqt_graph run zbot", has_verbs=False)

#: Commands of ROS 2, and the words of zbot that do the same.
COMMANDS = {
    **{name: f"zbot run {package} {name}" for name, package in BUNDLED_PROGRAMS.items()},
    "ros2": "zbot",
    "colcon": "zbot",
    "rqt_graph": "zbot web graph",
    "rqt": "zbot web",
    # These are commands of ROS 1. Some lessons show them beside the commands of ROS 2.
    "rosnode": "zbot node",
    "rostopic": "zbot topic",
}
_POSIX = (
    '{{name}}() {{{{ if {find} {{name}} >/dev/null; then command {{name}} "$@"; '
    'else {{words}} "$@"; fi; }}}}'
)
_BASH = _POSIX.format(find="type -P")
_ZSH = _POSIX.format(find="whence -p")
_FISH = "function {name}; if type -fq {name}; command {name} $argv; else; {words} $argv; end; end"
_POWERSHELL = (
    "function {name} {{ $real = Get-Command {name} -CommandType Application -ErrorAction Ignore "
    "| Select-Object -First 1; if ($real) {{ & $real @args }} else {{ {words} @args }} }}"
)
_LINES = {"bash": _BASH, "zsh": _ZSH, "fish": _FISH, "powershell": _POWERSHELL}
_INSTALL = {
    "bash": "zbot setup-shell bash >> ~/.bashrc",
    "zsh": "zbot setup-shell zsh >> ~/.zshrc",
    "fish": "zbot setup-shell fish >> ~/.config/fish/config.fish",
    "powershell": "zbot setup-shell powershell >> $PROFILE",
}


@app.command()
def setup_shell(
    shell: Annotated[str | None, typer.Argument(help="bash, zsh, fish or powershell")] = None,
) -> None:
    """Print shell functions named `ros2`, `colcon`, `rqt_plot` and so on, which run zbot.

    If this machine has a real ros2, the function `ros2` runs the real ros2. Without SHELL, print
    how to install the functions.
    """
    if shell is None:
        print("The words ros2, colcon and rqt_graph can run zbot. Type the line of your shell:\n")
        for line in _INSTALL.values():
            print(f"    {line}")
        print("\nThen open a new terminal.")
        return
    if shell not in _LINES:
        raise typer.BadParameter(f"no functions for {shell!r}; choose from {', '.join(_LINES)}")
    print(
        "# Functions of `zbot setup-shell`. A real ros2 on this machine still runs, and not zbot."
    )
    for name, words in COMMANDS.items():
        print(_LINES[shell].format(name=name, words=words))
