"""`zbot view`: shows the robot in 3D in a browser."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from zbot_cli.output.listing import new_app

_BAGS = (".mcap", ".db3", ".bag", ".zstd")

app = new_app("Show the robot in 3D in a browser", has_verbs=False)


@app.command()
def view(
    file: Annotated[
        Path | None,
        typer.Argument(
            help="Displays of rviz (.rviz), a robot (URDF) with its joints at 0, or a bag",
            exists=True,
        ),
    ] = None,
    host: Annotated[str, typer.Option("--host", help="Address to listen on")] = "127.0.0.1",
    port: Annotated[
        int, typer.Option("--port", help="Port to listen on; if it is taken, the next free port")
    ] = 8090,
    budget: Annotated[
        float | None,
        typer.Option(
            "--budget",
            min=0,
            help="Most kB/s to each browser; 0 means no limit; 200 for other machines if left out",
        ),
    ] = None,
    no_browser: Annotated[bool, typer.Option("--no-browser", help="Do not open a browser")] = False,
) -> None:
    """Show the robot in 3D in a browser."""
    from zbot.observer.serving.browser import has_desktop  # noqa: PLC0415 - as above
    from zbot.process.signals import install  # noqa: PLC0415 - not needed by `--help`
    from zbot.view.server.server import Content, bytes_per_s, serve  # noqa: PLC0415 - as above

    limit = bytes_per_s(host, budget)
    is_bag = file is not None and (file.is_dir() or file.suffix in _BAGS)
    content = (
        Content(bag=file, bytes_per_s=limit) if is_bag else Content(robot=file, bytes_per_s=limit)
    )
    if file is not None and file.suffix == ".rviz":
        from zbot.view.arrangement.rviz_file import read_rviz_file  # noqa: PLC0415 - as above

        content = Content(arrangement=read_rviz_file(file), bytes_per_s=limit)
    install(calls_ok=False)
    serve(host, port, open_browser=not no_browser and has_desktop(), content=content)
