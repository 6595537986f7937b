"""`zbot sim`: simulates robots in a world."""

from __future__ import annotations

import contextlib
import sys
from typing import Annotated

import typer

from zbot_cli.errors import CommandError
from zbot_cli.output.exit_status import Status
from zbot_cli.output.listing import new_app

app = new_app("Simulate robots in a world", has_verbs=False)
_LEAST_RATE, _MOST_RATE = 0.01, 100.0


@app.command()
def sim(
    world: Annotated[
        str,
        typer.Argument(
            help="room, maze, warehouse, office or arena; a map (.yaml), or a file of Gazebo "
            "(.sdf, .world) or MuJoCo (.xml)"
        ),
    ] = "room",
    robot: Annotated[
        list[str] | None,
        typer.Option("--robot", help="Name of a robot, or a file .urdf or .xacro; repeatable"),
    ] = None,
    robots: Annotated[
        int | None, typer.Option("--robots", help="Number of robots: robot1, robot2, ...")
    ] = None,
    headless: Annotated[bool, typer.Option("--headless", help="Do not open the 3D view")] = False,
    rate: Annotated[
        str, typer.Option("--rate", help="Simulated seconds in a real second, or max")
    ] = "1",
    seed: Annotated[int, typer.Option("--seed", min=0, help="Seed of the noise of sensors")] = 0,
    lockstep: Annotated[
        bool,
        typer.Option("--lockstep", help="Wait until each node that uses /clock has done its work"),
    ] = False,
    no_world_frame: Annotated[
        bool,
        typer.Option(
            "--no-world-frame", help="Do not publish world -> odom, e.g. beside a localiser"
        ),
    ] = False,
) -> None:
    """Simulate robots in a world."""
    from zbot.errors import ExternalShutdownException  # noqa: PLC0415 - not needed by `--help`
    from zbot.process.signals import ending_process  # noqa: PLC0415 - as above
    from zbot.simulation.engine import engine  # noqa: PLC0415 - as above

    with ending_process():
        engine()  # the other modules need numpy, which the extra brings
        from zbot.simulation.node.program import Options, simulate  # noqa: PLC0415 - as above
        from zbot.view.server.view_process import view_if_installed  # noqa: PLC0415 - as above

    options = Options(
        *(world, tuple(robot or ()), robots, _factor(rate), seed),
        has_world_frame=not no_world_frame,
        in_lockstep=lockstep,
        has_handles=not headless,
    )
    try:
        simulate(options, contextlib.nullcontext if headless else view_if_installed)
    except ExternalShutdownException:
        sys.exit(Status.TERMINATED)


def _factor(text: str) -> float | None:
    """Return a real-time factor, or None for `max`."""
    if text == "max":
        return None
    try:
        factor = float(text)
    except ValueError:
        factor = 0.0
    if not _LEAST_RATE <= factor <= _MOST_RATE:
        raise CommandError(f"--rate must be {_LEAST_RATE} to {_MOST_RATE}, or max, not '{text}'")
    return factor
