"""Simulate a world, as the programs `gz sim`, `ign gazebo`, `gazebo` and `gzserver` do.

Run:     zbot run gz_sim gz sim -r world.sdf
Options: -s without the 3D view, -g only the 3D view, --seed NUMBER, -u paused
Serves:  what `zbot sim` serves, and /world/NAME/create, /remove, /set_pose and /control
         (ros_gz_interfaces), or /spawn_entity and others (gazebo_msgs) for Gazebo Classic

The programs of Gazebo have many more options. They have no effect here.
"""

from __future__ import annotations

import contextlib
import sys
from pathlib import Path
from typing import NamedTuple

import zbot
from zbot.parameters.ros_args import remove_ros_args
from zbot_nodes.simulation.arguments import read_options

_FLAGS = (
    *("r", "s", "g", "u", "z", "verbose", "headless-rendering", "version", "pause", "lockstep"),
    *("force-version-only", "minimal_comms", "h", "help"),
)
_CLASSIC = frozenset({"gazebo", "gzserver", "gzclient"})


class Options(NamedTuple):
    """Options of a command line."""

    is_classic: bool
    world: str = "empty"
    has_world: bool = True  #: whether it simulates, and does not only show
    has_view: bool = True
    is_paused: bool = False
    seed: int = 0


def read_command(program: str, words: list[str]) -> Options:
    """Return the options of a command line.

    Args:
        program: The name of the program.
        words: The words after it.
    """
    is_classic = program in _CLASSIC
    if not is_classic and words[:1] in (["sim"], ["gazebo"]):
        words = words[1:]
    elif not is_classic and words and words[0].isalpha():
        sys.exit(
            f"error: zbot has no `{program} {words[0]}`: it has `{program} sim`, and for the rest "
            "the services and topics that `ros2 service list` and `ros2 topic list` show"
        )
    # In Gazebo Classic, `-s` and `-g` name a library, which may follow without a space.
    flags = [flag for flag in _FLAGS if not (is_classic and flag in {"s", "g", "r"})]
    if is_classic:
        words = [word for word in words if not word.startswith(("-slib", "-glib"))]
    else:
        words = _without_verbosity(words)
    options, others = read_options(words, flags)
    worlds = [word for word in others if not word.isdecimal()]
    return Options(
        is_classic,
        worlds[0] if worlds else "empty",
        has_world=program != "gzclient" and not (not is_classic and "g" in options),
        has_view=program != "gzserver" and (is_classic or "s" not in options),
        is_paused=is_classic and ("u" in options or "pause" in options),
        seed=int(options.get("seed", "0")) if options.get("seed", "0").isdecimal() else 0,
    )


def _without_verbosity(words: list[str]) -> list[str]:
    """Leave out `-v` and its number, which may be one word or two or be missing."""
    found, rest = [], list(words)
    while rest:
        word = rest.pop(0)
        if word in {"-v", "--verbose"}:
            if rest and rest[0].isdecimal():
                rest.pop(0)
        elif not (word.startswith("-v") and word[2:].isdecimal()):
            found.append(word)
    return found


def show() -> None:
    """Show the 3D view until Ctrl-C."""
    from zbot.view.server.view_process import view_if_installed  # noqa: PLC0415 - only with a view

    with zbot.init(), view_if_installed():
        zbot.spin(zbot.Node("gz_gui"))


def simulate(options: Options) -> None:
    """Simulate a world until Ctrl-C."""
    from zbot.process.signals import ending_process  # noqa: PLC0415 - as below
    from zbot.simulation.engine import engine  # noqa: PLC0415 - it needs an extra

    with ending_process():
        engine()  # the other modules need numpy, which the extra brings
        from zbot.simulation.node.gazebo_program import GazeboOptions, simulate_gazebo  # noqa: PLC0415
        from zbot.view.server.view_process import view_if_installed  # noqa: PLC0415 - only in a run
        from zbot_nodes.simulation.body_control import start_control  # noqa: PLC0415 - as above

    simulate_gazebo(
        GazeboOptions(
            options.world, options.is_classic, options.is_paused, options.seed, start_control
        ),
        view_if_installed if options.has_view else contextlib.nullcontext,
    )


def main() -> None:
    """Run until Ctrl-C."""
    program, *words = remove_ros_args()
    options = read_command(Path(program).name, words)
    try:
        if options.has_world:
            simulate(options)
        else:
            show()
    except zbot.ZbotError as error:
        sys.exit(f"error: {error}")


if __name__ == "__main__":
    main()
