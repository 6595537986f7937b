"""`zbot foxglove`: serves the running system to Foxglove and Lichtblick."""

from __future__ import annotations

from typing import Annotated

import typer

from zbot_cli.output.listing import new_app

app = new_app("Show the running system in Foxglove or Lichtblick", has_verbs=False)


@app.command()
def foxglove(
    host: Annotated[str, typer.Option("--host", help="Address to listen on")] = "127.0.0.1",
    port: Annotated[
        int, typer.Option("--port", help="Port to listen on; if it is taken, the next free port")
    ] = 8765,
    read_only: Annotated[
        bool, typer.Option("--read-only", help="Allow no changes from Foxglove")
    ] = False,
    origin: Annotated[
        list[str] | None,
        typer.Option("--origin", help="Address of a web page that may connect; repeatable"),
    ] = None,
) -> None:
    """Show the running system in Foxglove or Lichtblick."""
    from zbot.process.signals import install  # noqa: PLC0415 - not needed by `--help`
    from zbot.web.foxglove.server import serve  # noqa: PLC0415 - as above

    install(calls_ok=False)
    serve(host, port, read_only=read_only, origins=origin or (), on_ready=_print_addresses)


def _print_addresses(websocket: str, application: str) -> None:
    print(f"zbot foxglove: {websocket}", flush=True)
    print(f"In a browser:  {application}", flush=True)
    print("Ctrl-C ends the server", flush=True)
