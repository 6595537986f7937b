"""Layout of the page around a panel, with the list of panels, the title and the command."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING
from urllib.parse import urlencode

from nicegui import app, ui
from starlette.responses import RedirectResponse

from zbot.errors.suggestion import did_you_mean
from zbot.observer.errors import ViewerError
from zbot.version import __version__
from zbot.web.page.layout import read_layout_file
from zbot.web.page.panel import Page
from zbot.web.panels import PANELS
from zbot.web.panels.layout.panel import PANEL as LAYOUT

if TYPE_CHECKING:
    from collections.abc import Callable

    from starlette.requests import Request
    from starlette.responses import Response

    from zbot.observer.system import System
    from zbot.web.page.layout import Layout
    from zbot.web.page.panel import PageServer, Panel

_STATIC = Path(__file__).parent.parent / "static"
_ADDRESS = f"/_zbot/{__version__}"
# page.js comes first, because it creates the object `zbot`. The other scripts extend the object.
_SCRIPTS = (
    "page.js",
    "table.js",
    "graph.js",
    "picture.js",
    "plot.js",
    "turtle.js",
    "console.js",
    "drive.js",
    "sensors.js",
    "view.js",
    "output.js",
    "layout.js",
)
#: Former paths of panels, with the present path and its query.
_MOVED = {"/stick": ("/drive", {"topic": "/joy", "type": "sensor_msgs/msg/Joy"})}
_ICON = (
    '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 32 32">'
    '<rect width="32" height="32" rx="8" fill="#0b6bcb"/>'
    '<path d="M9 10h14L9 22h14" fill="none" stroke="#fff" stroke-width="3" '
    'stroke-linecap="round" stroke-linejoin="round"/></svg>'
)


def unknown_panel_error(name: str) -> ViewerError:
    """Return the error that the page has no panel with this name."""
    known = [panel.path.strip("/") for panel in PANELS]
    hint = did_you_mean(name, known) or f"there are {', '.join(known)}"
    return ViewerError(f"there is no panel {name!r}", hint=hint)


def check_path(path: str) -> None:
    """Check that a path is the path of a panel.

    Args:
        path: The path. It may have a query, e.g. `/plot?curve=/pose.x`.

    Raises:
        ViewerError: No panel has this path.
    """
    bare = path.partition("?")[0]
    if bare not in {*page_paths(), *_MOVED}:
        raise unknown_panel_error(bare.strip("/"))


def page_paths() -> set[str]:
    """Return the paths of all pages."""
    return {"/", *(panel.path for panel in PANELS)}


def ready_made(path: Path) -> Layout:
    """Return the layout in a file.

    Raises:
        LayoutError: The file cannot be read, or is not a layout.
    """
    return read_layout_file(path, [panel.path.strip("/") for panel in PANELS if panel != LAYOUT])


def add_pages(system: System, server: PageServer) -> None:
    """Serve each panel at its path, and the first panel at `/`."""
    # Browsers must not cache the files, because they would use old files after an update of zbot.
    app.add_static_files(_ADDRESS, str(_STATIC), max_cache_age=0)
    for name in _SCRIPTS:
        ui.add_head_html(f'<script src="{_ADDRESS}/{name}"></script>', shared=True)
    for name in ("page.css", "graph.css", "turtle.css", "drive.css", "sensors.css"):
        link = f'<link rel="stylesheet" href="{_ADDRESS}/{name}">'
        ui.add_head_html(link, shared=True)
    for panel in PANELS:
        ui.page(panel.path, title=f"{panel.title} - zbot", favicon=_ICON)(
            _page(panel, system, server)
        )
    for former, (path, query) in _MOVED.items():
        app.add_route(former, _redirection(path, query))
    ui.page("/", title=f"{PANELS[0].title} - zbot", favicon=_ICON)(_page(PANELS[0], system, server))


def _redirection(path: str, query: dict[str, str]) -> Callable[[Request], Response]:
    def redirect(request: Request) -> Response:
        return RedirectResponse(f"{path}?{urlencode({**query, **request.query_params})}")

    return redirect


def _page(panel: Panel, system: System, server: PageServer) -> Callable[[], None]:
    def build() -> None:
        client = ui.context.client
        page = Page(client, system, client.request.query_params, server)
        with ui.element("div").classes("zb-page"):
            _rail(panel, system)
            with ui.element("div").classes("zb-main"):  # NiceGUI puts it into a <main>
                with ui.element("header").classes("zb-top"):
                    with ui.element("h1").classes("zb-title"):
                        ui.label(panel.title)
                    page.toolbar = ui.element("div").classes("zb-toolbar")
                body = ui.element("div").classes("zb-body")
            _strip(page)
        with body:
            panel.build(page)

    return build


def _rail(current: Panel, system: System) -> None:
    with ui.element("nav").classes("zb-rail").props('aria-label="Panels"'):
        with ui.element("a").props('href="/" title="zbot"').classes("zb-brand"):
            ui.html(_ICON, sanitize=False).classes("zb-logo")
            ui.label("zbot").classes("zb-brand-name")
        for panel in PANELS:
            # A narrow page shows only the icon. The title is then the name of the link.
            link = ui.element("a").props(f'href="{panel.path}" title="{panel.title}"')
            link.classes("zb-link")
            if panel is current:
                link.classes("zb-current").props('aria-current="page"')
            with link:
                ui.icon(panel.icon).classes("zb-link-icon")
                ui.label(panel.title).classes("zb-link-text")
        ui.element("div").classes("zb-spring")
        if system.read_only:
            ui.label("read-only").classes("zb-badge")
        with ui.element("div").classes("zb-foot"):
            ui.label(f"domain {system.domain_id}").classes("zb-domain")
            button = ui.button(icon="contrast").props('flat round dense aria-label="Light or dark"')
            button.on("click", js_handler="() => zbot.switchTheme()")


def _strip(page: Page) -> None:
    with ui.element("footer").classes("zb-strip"):
        ui.label("$").classes("zb-prompt")
        text = ui.label().classes("zb-command").props('aria-label="The same on the command line"')
        button = ui.button(icon="content_copy").props('flat dense size=sm aria-label="Copy"')
        button.on("click", js_handler="() => zbot.copyCommand()")
    page.on_command(text.set_text)
