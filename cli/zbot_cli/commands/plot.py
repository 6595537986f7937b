"""`zbot plot`: plots numeric fields of topics over time, in the browser or in the terminal."""

from __future__ import annotations

from typing import Annotated
from urllib.parse import urlencode

import typer

from zbot_cli.output.listing import new_app

app = new_app("Plot numeric fields of topics", has_verbs=False)

_DEFAULT_WINDOW_S = 10.0


@app.command()
def plot(
    curves: Annotated[
        list[str] | None, typer.Argument(help="Topics and fields: /turtle1/pose.x")
    ] = None,
    terminal: Annotated[
        bool, typer.Option("--terminal", "-t", help="Draw in the terminal, not in a browser")
    ] = False,
    window: Annotated[
        float, typer.Option("--window", "-w", min=0.1, help="With --terminal: seconds to show")
    ] = _DEFAULT_WINDOW_S,
    duration: Annotated[
        float | None,
        typer.Option("--duration", help="With --terminal: end after this many seconds"),
    ] = None,
    port: Annotated[
        int, typer.Option("--port", help="Port of the page; if it is taken, the next free port")
    ] = 8080,
    no_browser: Annotated[bool, typer.Option("--no-browser", help="Do not open a browser")] = False,
) -> None:
    """Plot numeric fields of topics."""
    if terminal:
        if not curves:
            raise typer.BadParameter("say what to plot: zbot plot --terminal /turtle1/pose.x")
        _draw_here(curves, window, duration)
        return
    from zbot_cli.commands.web import serve_page  # noqa: PLC0415 - only for the page

    query = f"?{urlencode({'curve': ','.join(curves)}, safe='/,')}" if curves else ""
    serve_page(f"/plot{query}", port=port, open_browser=not no_browser)


def _draw_here(words: list[str], window_s: float, duration_s: float | None) -> None:
    from zbot.observer.curve import split_curve  # noqa: PLC0415 - as above
    from zbot.observer.system import System  # noqa: PLC0415 - as above
    from zbot.process.signals import install  # noqa: PLC0415 - only for the terminal
    from zbot_cli.output.terminal_plot import TerminalPlot  # noqa: PLC0415 - as above

    install(calls_ok=False)
    with System() as system:
        topics = [name for name, _ in system.snapshot().topics()]
        names = [split_curve(word, topics) for word in words]
        TerminalPlot(system, names, window_s=window_s, duration_s=duration_s).run()
