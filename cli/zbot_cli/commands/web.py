"""`zbot web`: serves the page that shows the running system in a browser."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Annotated

import typer

from zbot_cli.errors import CommandError
from zbot_cli.output.listing import new_app

_ALL_ADDRESSES = "0.0.0.0"  # noqa: S104 - other machines need the token

app = new_app("Show the running system in a browser", has_verbs=False)


@app.command()
def web(
    panel: Annotated[str, typer.Argument(help="Panel to open first, e.g. topics")] = "",
    host: Annotated[
        str | None,
        typer.Option(
            "--host", help="Address to listen on; default: 127.0.0.1, or with --https all"
        ),
    ] = None,
    port: Annotated[
        int, typer.Option("--port", help="Port to listen on; if it is taken, the next free port")
    ] = 8080,
    no_browser: Annotated[bool, typer.Option("--no-browser", help="Do not open a browser")] = False,
    read_only: Annotated[
        bool, typer.Option("--read-only", help="Allow no changes from the page")
    ] = False,
    rosbridge: Annotated[
        bool,
        typer.Option("--rosbridge", help="Serve web programs too, e.g. programs that use roslibjs"),
    ] = False,
    origin: Annotated[
        list[str] | None,
        typer.Option("--origin", help="Web server whose pages may use rosbridge too; repeatable"),
    ] = None,
    layout: Annotated[
        Path | None,
        typer.Option("--layout", help="File with panels that the page shows side by side"),
    ] = None,
    https: Annotated[
        bool,
        typer.Option("--https", help="Serve the network with https, e.g. for a phone's sensors"),
    ] = False,
) -> None:
    """Show the running system in a browser."""
    serve_page(
        f"/{panel.lstrip('/')}" if panel or layout is None else "/layout",
        host=host or (_ALL_ADDRESSES if https else "127.0.0.1"),
        port=port,
        open_browser=not no_browser,
        read_only=read_only,
        rosbridge=rosbridge or bool(origin),
        guests=origin or (),
        layout=layout,
        https=https,
    )


def serve_page(
    path: str,
    *,
    host: str = "127.0.0.1",
    port: int = 8080,
    open_browser: bool = True,
    read_only: bool = False,
    rosbridge: bool = False,
    guests: Sequence[str] = (),
    layout: Path | None = None,
    https: bool = False,
) -> None:
    """Serve the page until Ctrl-C, and open it in a browser at a path. See `zbot.web.server`.

    Raises:
        CommandError: The extra `web` is not installed.
    """
    from zbot.process.signals import install  # noqa: PLC0415 - not needed by `--help`

    check_extra()
    from zbot.observer.serving.browser import has_desktop  # noqa: PLC0415 - as above
    from zbot.web.server.server import serve  # noqa: PLC0415 - as above

    install(calls_ok=False)
    serve(
        host,
        port,
        open_browser=open_browser and has_desktop(),
        read_only=read_only,
        start_path=path,
        rosbridge=rosbridge,
        guests=guests,
        layout=layout,
        https=https,
    )


def check_extra() -> None:
    """Check that the packages of the extra `web` are installed.

    Raises:
        CommandError: One of the packages is not installed.
    """
    from importlib.util import find_spec  # noqa: PLC0415 - only the page needs it

    for module, name in (("nicegui", "nicegui"), ("psutil", "psutil"), ("PIL", "pillow")):
        if find_spec(module) is None:
            from zbot.errors.installation import pip_install  # noqa: PLC0415 - as above

            raise CommandError(f"the page needs {name}: install it with {pip_install('zbot[web]')}")
