"""Panel of turtlesim, with turtles, lines, and controls for driving, pens and services."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from nicegui import ui

from zbot.web.page.panel import Page, Panel
from zbot.web.page.service_call import with_errors_shown
from zbot.web.panels.turtle.turtle_control import (
    ARROWS,
    CANCEL,
    HEADINGS,
    Simulator,
    TurtleControl,
    simulators,
)
from zbot.web.panels.turtle.turtle_scene import SceneView

if TYPE_CHECKING:
    from collections.abc import Callable, Coroutine

    from nicegui.events import GenericEventArguments

    from zbot.web.panels.turtle.turtle_scene import SeenTurtle

_RUN = "zbot run turtlesim turtlesim_node"
_ARROW_ICONS = {
    "ArrowLeft": "keyboard_arrow_left",
    "ArrowUp": "keyboard_arrow_up",
    "ArrowDown": "keyboard_arrow_down",
    "ArrowRight": "keyboard_arrow_right",
}
_BLACK = "#000000"
#: Keys that turn the turtle. They have the same order around F as on a keyboard.
_WHEEL = ("e", "r", "t", "d", CANCEL, "g", "c", "v", "b")


class TurtlePanel:
    """Panel of turtlesim in one browser.

    Args:
        page: The page.
    """

    def __init__(self, page: Page) -> None:
        self._page = page
        self._scene_view = SceneView(page)
        self._control: TurtleControl | None = None
        self._chosen = ""
        self._revision = -1
        self._names: list[str] = []
        page.show_command(_RUN)
        with page.toolbar:
            self._simulator = ui.select([], on_change=self._on_simulator).props(
                'dense outlined options-dense aria-label="Simulator"'
            )
        self._build()
        ui.on("zbot_turtle_key", lambda event: self.press(event.args))
        ui.on("zbot_turtle", lambda event: self._choose(str(event.args)))
        page.live(self._update)

    def _build(self) -> None:
        with ui.element("div").classes("zb-turtle-page"):
            with ui.element("div").classes("zb-col"):
                self._build_scene()
            with ui.element("div").classes("zb-col zb-turtle-side") as self._side:
                self._build_driving()
                self._build_turtle()
                self._build_world()
        self._side.set_visibility(not self._page.read_only)

    def _build_scene(self) -> None:
        with ui.element("div").classes("zb-stage").props('role=group aria-label="Turtles"'):
            ui.element("canvas").classes("zb-sheet")
            ui.element("svg").classes("zb-turtles").props('viewBox="0 0 500 500"')
            self._empty = ui.label(f"No turtlesim is running. Start one:  {_RUN}")
            self._empty.classes("zb-stage-empty")
        self._place = ui.label().classes("zb-mono zb-muted zb-turtle-place")

    def _build_driving(self) -> None:
        with ui.element("div").classes("zb-card zb-drive"):
            with ui.element("div").classes("zb-col"):
                ui.label("Drive").classes("zb-heading")
                with ui.element("div").classes("zb-arrows"):
                    for key, icon in _ARROW_ICONS.items():
                        button = self._key(key, icon=icon)
                        button.props(f'aria-label="{key}"').classes(f"zb-{key.lower()}")
            with ui.element("div").classes("zb-col"):
                ui.label("Turn to").classes("zb-heading")
                with ui.element("div").classes("zb-wheel"):
                    for key in _WHEEL:
                        button = self._key(key, text=key.upper())
                        is_heading = key in HEADINGS
                        button.tooltip(f"{HEADINGS[key]} rad" if is_heading else "Stop turning")
            ui.label(
                "The keys do the same: arrows, the letters around F, and F to stop turning."
            ).classes("zb-muted zb-hint")

    def _key(self, key: str, text: str = "", icon: str | None = None) -> ui.button:
        button = ui.button(text, icon=icon, on_click=lambda: self.press(key))
        return button.props("outline dense").classes("zb-key")

    def _build_turtle(self) -> None:
        with ui.element("div").classes("zb-card zb-col zb-inputs"):
            with ui.element("div").classes("zb-row"):
                ui.label("Turtle").classes("zb-heading zb-caption")
                self._turtle = ui.select([], on_change=self._on_turtle).props(
                    'dense outlined options-dense aria-label="Turtle"'
                )
                ui.element("div").classes("zb-grow")
                self._button("Kill", self._kill, "Remove this turtle").classes("zb-danger")
            with ui.element("div").classes("zb-row"):
                ui.label("Pen").classes("zb-heading zb-caption")
                self._pen_colour = _colour("Pen colour", self._set_pen)
                self._pen_width = _number("width", 3, "px")
                self._pen_width.on("change", with_errors_shown(self._set_pen))
                self._pen_down = ui.switch("draws", value=True).props("dense")
                self._pen_down.on("click", with_errors_shown(self._set_pen))
            with ui.element("div").classes("zb-row"):
                ui.label("Place").classes("zb-heading zb-caption")
                self._x = _number("x", 2.0, "m")
                self._y = _number("y", 2.0, "m")
                self._theta = _number("theta", 0.0, "rad")
            with ui.element("div").classes("zb-row zb-indented"):
                self._button("Teleport", self._teleport, "Move the turtle here, drawing a line")
                self._button("Spawn another", self._spawn, "Add a turtle here")
                self._new_name = ui.input(placeholder="name").props("dense outlined")
                self._new_name.classes("zb-new-name").props('aria-label="Name of the new turtle"')

    def _build_world(self) -> None:
        with ui.element("div").classes("zb-card zb-row zb-inputs"):
            ui.label("World").classes("zb-heading zb-caption")
            self._background = _colour("Background colour", self._set_background)
            ui.label("background").classes("zb-muted")
            ui.element("div").classes("zb-grow")
            self._button("Clear", self._clear, "Remove the lines")
            self._button("Reset", self._reset, "Restart with one turtle")

    def _button(
        self, text: str, act: Callable[[], Coroutine[Any, Any, None]], hint: str
    ) -> ui.button:
        button = ui.button(text, on_click=with_errors_shown(act), color=None)
        button.props("outline dense no-wrap")
        return button.classes("zb-button").tooltip(hint)

    def _update(self) -> None:
        if self._revision != self._page.system.revision:
            self._revision = self._page.system.revision
            self._match_simulators()
        self._scene_view.update()
        if list(self._scene_view.turtles) != self._names:
            self._match_turtles()
        seen = self._scene_view.turtles.get(self._chosen)
        self._place.set_text(_place(seen) if seen is not None else "")
        _keep(self._background, _hex(self._scene_view.background))
        if seen is not None:
            self._match_pen(seen)

    def _match_simulators(self) -> None:
        found = {
            simulator.node: simulator for simulator in simulators(self._page.system.snapshot())
        }
        self._simulator.set_options(list(found))
        self._simulator.set_visibility(len(found) > 1)
        self._empty.set_visibility(not found)
        wanted = self._page.query.pop("node", self._simulator.value)
        chosen = found.get(wanted) or next(iter(found.values()), None)
        if chosen != (self._control.simulator if self._control is not None else None):
            self._look_at(chosen)

    def _on_simulator(self) -> None:
        found = simulators(self._page.system.snapshot())
        chosen = next(
            (simulator for simulator in found if simulator.node == self._simulator.value), None
        )
        if chosen is not None and self._control is not None and chosen != self._control.simulator:
            self._look_at(chosen)

    def _look_at(self, simulator: Simulator | None) -> None:
        if self._control is not None:
            self._control.close()
        self._control = TurtleControl(self._page, simulator) if simulator is not None else None
        self._scene_view.look_at(simulator)
        if simulator is not None:
            self._simulator.set_value(simulator.node)
            inside = simulator.namespace != "/"
            place = f" --ros-args -r __ns:={simulator.namespace}" if inside else ""
            self._page.show_command(_RUN + place)

    def _match_turtles(self) -> None:
        self._names = list(self._scene_view.turtles)
        self._turtle.set_options(self._names)
        if self._chosen not in self._names:
            self._choose(self._names[0] if self._names else "")
        else:
            self._turtle.set_value(self._chosen)

    def _on_turtle(self) -> None:
        if self._turtle.value and self._turtle.value != self._chosen:
            self._choose(self._turtle.value)

    def _choose(self, name: str) -> None:
        self._chosen = name
        self._turtle.set_value(name or None)
        self._page.call("zbotTurtle.choose", name)
        if name and self._control is not None:
            self._control.prepare(name)
            pose = self._control.simulator.name(f"{name}/pose")
            self._page.show_command(f"zbot topic echo {pose}")

    def _match_pen(self, seen: SeenTurtle) -> None:
        _keep(self._pen_colour, _hex(seen.pen))
        _keep(self._pen_width, seen.pen_width)
        _keep(self._pen_down, seen.is_pen_down)

    async def press(self, key: str) -> None:
        """Drive, turn or stop, depending on the key."""
        await with_errors_shown(self._press)(key)

    async def _press(self, key: str) -> None:
        if self._control is None or not self._chosen:
            return
        if key in ARROWS:
            self._control.drive(self._chosen, *ARROWS[key])
        elif key in HEADINGS:
            await self._control.rotate(self._chosen, HEADINGS[key])
        elif key == CANCEL:
            await self._control.cancel(self._chosen)

    async def _kill(self) -> None:
        if self._control is not None and self._chosen:
            await self._control.kill(self._chosen)

    async def _spawn(self) -> None:
        if self._control is None:
            return
        name = await self._control.spawn(*self._where(), self._new_name.value or "")
        if name:
            self._choose(name)
            self._new_name.set_value("")
        else:
            ui.notify(_why_no_turtle(self._new_name.value or "", self._names), type="negative")

    async def _teleport(self) -> None:
        if self._control is not None and self._chosen:
            await self._control.teleport(self._chosen, *self._where())

    def _where(self) -> tuple[float, float, float]:
        x, y, theta = (float(field.value or 0.0) for field in (self._x, self._y, self._theta))
        return x, y, theta

    async def _set_pen(self, _event: object = None) -> None:
        if self._control is not None and self._chosen:
            colour, width = (
                _channels(self._pen_colour.value or _BLACK),
                int(self._pen_width.value or 0),
            )
            is_down = bool(self._pen_down.value)
            width = min(max(width, 0), 255)
            await self._control.set_pen(self._chosen, colour, width, is_down=is_down)

    async def _set_background(self) -> None:
        if self._control is not None:
            await self._control.set_background(_channels(self._background.value or _BLACK))

    async def _clear(self) -> None:
        if self._control is not None:
            await self._control.clear()

    async def _reset(self) -> None:
        if self._control is not None:
            await self._control.reset()


def _why_no_turtle(name: str, taken: list[str]) -> str:
    if name in taken:
        return f"A turtle named {name} already exists"
    return f"{name!r} is not a valid name: use letters, digits and underscores"


def _colour(label: str, on_choice: Callable[[], Coroutine[Any, Any, None]]) -> ui.input:
    box = ui.input(value=_BLACK).props(f'dense borderless type=color aria-label="{label}"')

    async def choose(event: GenericEventArguments) -> None:
        box.set_value(event.args)
        await with_errors_shown(on_choice)()

    # The event "change" comes once. The event "input" would come for each colour while the user
    # moves the mouse.
    box.on("change", choose, js_handler="(value) => emit(value)")
    return box.classes("zb-colour")


def _number(label: str, value: float, unit: str) -> ui.number:
    number = ui.number(value=value, prefix=label, suffix=unit)
    number.props(f'dense outlined aria-label="{label}"')
    return number.classes("zb-short-number")


def _keep(element: Any, value: object) -> None:
    """Show a simulator's value only when the value changes, so that the user's input stays."""
    shown = getattr(element, "last_shown", None)
    if shown != value:
        element.last_shown = value
        element.set_value(value)


def _place(seen: SeenTurtle) -> str:
    return f"{seen.name}   x {seen.x:.2f} m   y {seen.y:.2f} m   theta {seen.theta:.2f} rad"


def _hex(colour: tuple[int, int, int]) -> str:
    return "#" + "".join(f"{channel:02x}" for channel in colour)


def _channels(text: str) -> tuple[int, int, int]:
    return int(text[1:3], 16), int(text[3:5], 16), int(text[5:7], 16)


def _build(page: Page) -> None:
    TurtlePanel(page)


PANEL = Panel("/turtle", "Turtle", "pets", _build)
