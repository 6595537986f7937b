"""Panel beside the scene: the fixed frame, the topics that can be shown, and their displays."""

from __future__ import annotations

import base64
import enum
import html
from functools import partial
from typing import TYPE_CHECKING, Any

from zbot.view.arrangement.rviz_writer import FILE_NAME
from zbot.view.camera import VIEWS
from zbot.view.shape import Note, Picture
from zbot.view.tools.pointer import TOOL_NAMES

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence

    from zbot.view.camera import Camera
    from zbot.view.displays.display import Display, Setting, Value

#: First choice of the fixed frame, and of the frame that the view follows.
AUTOMATIC = "(automatic)"
FIXED = "(none)"
_LONGEST_TEXT = 400
_LONGEST_DESCRIPTION = 4000
_MOST_FRAMES = 500
_MOST_MENUS = 20
_NO_ENTRY = "(choose)"
_SPEEDS = ("0.1", "0.25", "0.5", "1", "2", "4", "10")
_STYLE = "padding:0 .6em;font-size:.8em;line-height:1.3;white-space:pre-wrap;overflow-wrap:anywhere"
_MUTED = "#6b7280"
_WARNING = "#b45309"
# A link of the page, which the guard answers. A click on a button of viser is lost while the
# browser has no websocket.
_SAVE = (
    f'<a href="/{FILE_NAME}" download="{FILE_NAME}" style="display:block;margin:0 .75em '
    ".6em;line-height:2;border-radius:2px;background:#228be6;color:#fff;font-size:.8em;"
    'text-align:center;text-decoration:none">Save as .rviz</a>'
)


class Wish(enum.Enum):
    """What a user wants, with the type of the value."""

    FIXED_FRAME = enum.auto()  #: str; an empty name means that the view chooses it
    TARGET = enum.auto()  #: str; an empty name means the fixed frame
    TURN = enum.auto()  #: bool
    VIEW = enum.auto()  #: str, a key of `VIEWS`
    PAUSE = enum.auto()  #: bool
    TOOL = enum.auto()  #: str, one of `TOOL_NAMES`
    CLICK = enum.auto()  #: Ray in the fixed frame
    LINK = enum.auto()  #: None
    PLAY = enum.auto()  #: bool
    SEEK = enum.auto()  #: float, in seconds since the start of the bag
    SPEED = enum.auto()  #: float


class Row:
    """Topic in the panel, with a switch, the settings of its display and a sentence.

    Args:
        gui: viser's `GuiApi`. New elements appear where it is open.
        label: The text beside the switch.
        is_on: Whether the display is on at first.
        switch: Called with the new state after the user has changed the switch.
    """

    def __init__(
        self, gui: Any, label: str, *, is_on: bool, switch: Callable[[bool], None]
    ) -> None:
        self._gui = gui
        self._folder = gui.add_folder(None)
        with self._folder:
            self._switch = gui.add_checkbox(_short(label, 60), is_on, hint=_short(label, 200))
            self._sentence = gui.add_html("", visible=False)
            self._content = gui.add_html("", visible=False)
        _on_choice(self._switch.on_update, switch)
        self._settings: Any = None
        self._menus: dict[str, Any] = {}
        self._offered: Mapping[str, tuple[str, ...]] = {}
        self._said: tuple[str, bool] | None = None
        self._shown: tuple[object, ...] = ()

    def open(self, display: Display, change: Callable[[str, Value], None]) -> None:
        """Show the settings of the display."""
        if not display.settings:
            return
        with self._folder:
            self._settings = self._gui.add_folder("Settings", expand_by_default=False)
        with self._settings:
            for setting in display.settings:
                self._input(setting, display.values[setting.name], change)

    def _input(self, setting: Setting, value: Value, change: Callable[[str, Value], None]) -> None:
        gui, name = self._gui, setting.name
        if isinstance(value, bool):
            handle = gui.add_checkbox(name, value)
        elif setting.choices:
            handle = gui.add_dropdown(name, setting.choices, initial_value=value)
        elif isinstance(value, tuple):
            handle = gui.add_rgb(name, value)
        elif isinstance(value, str):
            handle = gui.add_text(name, value)
        else:
            # A file may have a number outside of the usual limits.
            low, high = min(setting.low, value), max(setting.high, value)
            handle = gui.add_slider(name, low, high, setting.step, value)
        _on_choice(handle.on_update, partial(change, name))

    def close(self) -> None:
        """Remove the settings, the sentence and the pictures."""
        if self._settings is not None:
            self._settings.remove()
            self._settings = None
        self.say("")
        self.show(())
        self.offer({}, lambda _menu, _entry: None)

    def say(self, sentence: str, *, is_warning: bool = False) -> None:
        """Show a sentence below the switch."""
        if self._said == (sentence, is_warning):
            return
        self._said = (sentence, is_warning)
        self._sentence.content = text_html(sentence, _WARNING if is_warning else _MUTED)
        self._sentence.visible = bool(sentence)

    def show(self, shapes: Sequence[Picture | Note]) -> bool:
        """Show pictures and lines of text. Return whether they are new."""
        if self._shown == tuple(shapes):
            return False
        self._shown = tuple(shapes)
        self._content.content = "".join(map(_content_html, shapes))
        self._content.visible = bool(shapes)
        return True

    def offer(
        self, menus: Mapping[str, tuple[str, ...]], choose: Callable[[str, str], None]
    ) -> None:
        """Show a list of entries for each menu. An entry is chosen once for each click."""
        if menus == self._offered:
            return
        self._offered = menus
        for name in [*self._menus]:
            self._menus.pop(name).remove()
        for name, entries in [*menus.items()][:_MOST_MENUS]:
            with self._folder:
                self._menus[name] = self._menu(name, entries, choose)

    def _menu(self, name: str, entries: tuple[str, ...], choose: Callable[[str, str], None]) -> Any:
        options = (_NO_ENTRY, *(_short(entry, 60) for entry in dict.fromkeys(entries)))
        whole = dict(zip(options[1:], dict.fromkeys(entries), strict=True))
        handle = self._gui.add_dropdown(_short(name, 60), options, initial_value=_NO_ENTRY)

        def take(entry: str) -> None:
            if entry in whole:
                choose(name, whole[entry])
                handle.value = _NO_ENTRY  # the same entry can be chosen again

        _on_choice(handle.on_update, take)
        return handle

    def remove(self) -> None:
        """Remove the row."""
        self._folder.remove()


class Panel:
    """The panel of all users: what is chosen in one browser is chosen in all.

    Args:
        gui: viser's `GuiApi`.
        title: The title of the panel.
        ask: Called with what the user wants, e.g. `Wish.FIXED_FRAME`, and the value that the user
            has chosen.
    """

    def __init__(self, gui: Any, title: str, ask: Callable[[Wish, Any], None]) -> None:
        self._gui, self._ask = gui, ask
        gui.set_panel_label(title)
        self.set_dark(is_dark=False)
        self._frame = self._frames_list("Fixed frame", AUTOMATIC, 0, Wish.FIXED_FRAME)
        self._sentence = gui.add_html("", order=1)
        self._note = gui.add_html("", order=2, visible=False)
        self._said: tuple[str, bool] = ("", False)
        self._groups: dict[str, Any] = {}
        self._tool = gui.add_dropdown("Tool", TOOL_NAMES, initial_value=TOOL_NAMES[0], order=3)
        _on_choice(self._tool.on_update, partial(ask, Wish.TOOL))
        self._tool_sentence = gui.add_html("", order=4, visible=False)
        self._tool_said = ""
        with gui.add_folder("View", order=5, expand_by_default=False):
            self._add_view()

    def _add_view(self) -> None:
        gui, ask = self._gui, self._ask
        self._target = self._frames_list("Follow the frame", FIXED, 0, Wish.TARGET)
        self._turns = gui.add_checkbox("Turn with it", False)
        _on_choice(self._turns.on_update, partial(ask, Wish.TURN))
        look = gui.add_button_group("Look from", tuple(VIEWS))
        _on_choice(look.on_click, partial(ask, Wish.VIEW))
        gui.add_html(_SAVE)
        gui.add_button("Make a link").on_click(lambda _: ask(Wish.LINK, None))
        self._link = gui.add_text("Link", "", visible=False)
        pause = gui.add_checkbox("Pause", False)
        _on_choice(pause.on_update, partial(ask, Wish.PAUSE))

    def _frames_list(self, label: str, first: str, order: float, wish: Wish) -> Any:
        found = self._gui.add_dropdown(label, (first,), initial_value=first, order=order)
        _on_choice(found.on_update, lambda name: self._ask(wish, "" if name == first else name))
        return found

    def set_dark(self, *, is_dark: bool) -> None:
        """Choose light or dark colours."""
        self._gui.configure_theme(
            show_logo=False, show_share_button=False, control_width="medium", dark_mode=is_dark
        )

    def offer_frames(self, names: Sequence[str]) -> None:
        """Offer frames in the lists. A chosen frame stays, even if it is gone."""
        for handle in (self._frame, self._target):
            options = (handle.options[0], *names[:_MOST_FRAMES])
            if handle.value not in options:
                options = (*options, handle.value)
            if options != handle.options:
                handle.options = options

    def choose(self, fixed_frame: str, camera: Camera | None) -> None:
        """Show the fixed frame and the view of an arrangement, as if the user had chosen them."""
        if fixed_frame:
            _select(self._frame, fixed_frame)
        if camera is not None and camera.target:
            _select(self._target, camera.target)
        if camera is not None:
            self._turns.value = camera.turns

    def say(self, sentence: str, *, is_warning: bool = False) -> None:
        """Show a sentence about the scene."""
        if (sentence, is_warning) != self._said:
            self._said = (sentence, is_warning)
            self._sentence.content = text_html(sentence, _WARNING if is_warning else _MUTED)

    def say_of_tool(self, sentence: str) -> None:
        """Show a text of the tool."""
        if sentence != self._tool_said:
            self._tool_said = sentence
            self._tool_sentence.content = text_html(sentence, "inherit", _LONGEST_DESCRIPTION)
            self._tool_sentence.visible = bool(sentence)

    def add_timeline(self, length_s: float) -> None:
        """Add the controls of a bag."""
        gui, ask = self._gui, self._ask
        with gui.add_folder("Bag", order=-1):
            self._play = gui.add_checkbox("Play", True)
            self._time = gui.add_slider("Time in s", 0.0, max(length_s, 0.1), 0.1, 0.0)
            speed = gui.add_dropdown("Speed", _SPEEDS, initial_value="1")
        # The view itself changes the first two. Only what a browser changes is a wish.
        _on_choice(self._play.on_update, partial(ask, Wish.PLAY), only_in_browser=True)
        _on_choice(self._time.on_update, partial(ask, Wish.SEEK), only_in_browser=True)
        _on_choice(speed.on_update, lambda text: ask(Wish.SPEED, float(text)))

    def show_time(self, position_s: float, *, is_playing: bool) -> None:
        """Show where a bag is."""
        position_s = round(position_s, 1)
        if self._time.value != position_s:
            self._time.value = min(position_s, self._time.max)
        if self._play.value != is_playing:
            self._play.value = is_playing

    def show_link(self, link: str) -> None:
        """Show an address that the user can copy."""
        self._link.value = link
        self._link.visible = True

    def note(self, sentence: str) -> None:
        """Show a sentence about the arrangement."""
        self._note.content = text_html(sentence, _WARNING)
        self._note.visible = bool(sentence)

    def add(
        self, group: str, place: int, label: str, *, is_on: bool, switch: Callable[[bool], None]
    ) -> Row:
        """Add a topic to the group of a display. Groups are in the order of their places."""
        if group not in self._groups:
            self._groups[group] = self._gui.add_folder(group, order=place)
        with self._groups[group]:
            return Row(self._gui, label, is_on=is_on, switch=switch)

    def drop(self, group: str) -> None:
        """Remove a group that has no topics any more."""
        self._groups.pop(group).remove()


def _on_choice(
    register: Callable[[Any], object],
    take: Callable[[Any], object],
    *,
    only_in_browser: bool = False,
) -> None:
    """Call a function with each new value of an element, in viser's event loop.

    Args:
        register: Method of the element that takes a callback.
        take: Called with the value.
        only_in_browser: Whether values that the view has set do not count.
    """

    # A coroutine: viser calls functions later, in other threads. The view may have written
    # another value by then, and the user's choice would be lost.
    async def tell(event: Any) -> None:
        if event.client or not only_in_browser:
            take(event.target.value)

    register(tell)


def _select(handle: Any, value: str) -> None:
    if value not in handle.options:
        handle.options = (*handle.options, value)
    handle.value = value


def text_html(text: str, color: str, longest: int = _LONGEST_TEXT) -> str:
    """Return a text of another program as HTML that shows its letters, and nothing else."""
    shown = html.escape(_short(text, longest))
    return f'<div style="{_STYLE};color:{color}">{shown}</div>'


def _content_html(shape: Picture | Note) -> str:
    if isinstance(shape, Note):
        return text_html(shape.text, "inherit")
    data = base64.b64encode(shape.data).decode()
    source = f"data:{html.escape(shape.media_type)};base64,{data}"
    return f'<img alt="picture" style="width:100%" src="{source}">'


def _short(text: str, longest: int) -> str:
    return text if len(text) <= longest else f"{text[: longest - 1]}…"
