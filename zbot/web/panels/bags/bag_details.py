"""Details of a bag in the live page: timeline, topics, plot and export."""

from __future__ import annotations

import contextlib
from functools import partial
from typing import TYPE_CHECKING, Any
from weakref import finalize

from nicegui import ui

from zbot.bag.columns import fields_of, topic_columns
from zbot.bag.player import PlayerStatus
from zbot.errors import ZbotError
from zbot.observer.curve import thinned
from zbot.observer.errors import ViewerError
from zbot.observer.image_encoder import IMAGE_TYPES
from zbot.time import S_TO_NS
from zbot.web.page.command_line import command_line
from zbot.web.page.service_call import EXPORTING, READING, run_in_thread, with_errors_shown
from zbot.web.panels.bags.bag_curves import BagCurves
from zbot.web.panels.bags.bag_export import (
    export_csv,
    export_video,
    new_export_file,
    write_export,
)
from zbot.web.panels.bags.end_notice import EndNotice

if TYPE_CHECKING:
    from pathlib import Path

    from zbot.bag.background import BackgroundPlayback
    from zbot.bag.metadata import BagMetadata
    from zbot.bag.player import Player
    from zbot.web.page.panel import Section
    from zbot.web.panels.bags.bag_control import BagControl
    from zbot.web.panels.bags.bag_export import Export

_HZ = 10.0
_RATES = {0.1: "0.1 x", 0.25: "0.25 x", 0.5: "0.5 x", 1: "1 x", 2: "2 x", 5: "5 x", 10: "10 x"}
_PLOT_POINTS = 2000
_STEP_S = 0.01


class BagDetails:
    """Timeline with buttons, topics, a plot of the whole bag, and the export of a part.

    Args:
        section: The section of the page.
        control: The recording and playback of the page.
        name: The name of the bag.
    """

    def __init__(self, section: Section, control: BagControl, name: str) -> None:
        self.section, self.control, self.name = section, control, name
        self.metadata: BagMetadata | None = None
        self.chosen_s: float | None = None  #: where the user holds the timeline, in seconds
        self.end_notice = EndNotice("playback", self.playback)
        self.body = ui.element("div").classes("zb-col")
        section.page.show_command(command_line("bag", "info", name))
        ui.timer(0.01, with_errors_shown(self.fill), once=True)

    async def fill(self) -> None:
        """Read the bag's description, and add the elements."""
        found = (await run_in_thread(self.control.bags, threads=READING)).get(self.name)
        if found is None or found.metadata is None:
            ui.label("There is no bag with this name." if found is None else found.problem)
            return
        self.metadata = found.metadata
        with self.body:
            if found.problem:
                ui.label(f"Only a part can be read: {found.problem}").classes("zb-warn")
            self.add_timeline()
            self.add_topics()
            self.add_plot()
            self.add_export()
        self.section.live(self.update, _HZ)

    @property
    def duration_s(self) -> float:
        """Seconds from the first message to the last one."""
        return self.metadata.duration_ns / S_TO_NS if self.metadata else 0.0

    @property
    def player(self) -> Player | None:
        """The player of this bag, or `None` if this bag is not being played."""
        playback = self.control.playing(self.name)
        return None if playback is None else playback.player

    def playback(self) -> BackgroundPlayback | None:
        """Return the last playback of this bag, which may have ended."""
        playback = self.control.playback
        return playback if playback is not None and playback.path.name == self.name else None

    def add_timeline(self) -> None:
        """Add the buttons of the player, and the timeline."""
        with ui.element("div").classes("zb-row"):
            self.play_button = ui.button(icon="play_arrow", on_click=with_errors_shown(self.play))
            self.play_button.props('unelevated dense aria-label="Play"')
            step = ui.button(icon="skip_next", on_click=with_errors_shown(self.step))
            step.props('outline dense aria-label="Step"').tooltip("Publish the next message")
            stop = ui.button(icon="stop", on_click=with_errors_shown(self.stop))
            stop.props('outline dense aria-label="Stop playing"')
            self.rate = ui.select(_RATES, value=1, on_change=self.change_rate)
            self.rate.props('dense outlined aria-label="Speed"')
        self.time = ui.label().classes("zb-mono")
        longest = max(self.duration_s, _STEP_S)
        self.slider = ui.slider(min=0, max=longest, step=_STEP_S, value=0)
        self.slider.props('aria-label="Time" dense').classes("zb-timeline")
        # The first event comes only when the user moves the slider, not when `update` does. The
        # value of the second one may be that of an `update` while the user held the slider.
        self.slider.on("update:model-value", self.choose, js_handler="(value) => emit(value)")
        self.slider.on("change", with_errors_shown(self.seek))
        for element in (self.play_button, step, stop, self.rate, self.slider):
            element.set_enabled(not self.section.page.read_only)

    def add_topics(self) -> None:
        """Add a checkbox for each topic that can be played."""
        ui.label("Topics").classes("zb-heading")
        self.boxes = {}
        for information in self.metadata.topics if self.metadata else ():
            with ui.element("div").classes("zb-row"):
                box = ui.checkbox(information.topic.name, value=True).props("dense")
                box.classes("zb-mono zb-grow")
                ui.label(f"{information.topic.type_name}, {information.message_count}").classes(
                    "zb-muted"
                )
            self.boxes[information.topic.name] = box

    def add_plot(self) -> None:
        """Add the choice of a curve, and the plot."""
        ui.label("Plot of the whole bag").classes("zb-heading")
        self.curve = ui.select(self.curves(), multiple=True, on_change=with_errors_shown(self.draw))
        self.curve.props('dense outlined use-chips aria-label="Curves"')
        self.chart = ui.echart({}, renderer="svg").classes("zb-bag-chart")
        self.chart.set_visibility(False)
        self.chosen_curves = BagCurves(
            lambda name: run_in_thread(self.read_curve, name, threads=EXPORTING)
        )

    def add_export(self) -> None:
        """Add the choice of a part, and the buttons to export it."""
        ui.label("Export a part").classes("zb-heading")
        names = list(self.boxes)
        with ui.element("div").classes("zb-row"):
            self.topic = ui.select(names, value=names[0] if names else None)
            self.topic.props('dense outlined aria-label="Topic to export"').classes("zb-grow")
            self.start = ui.number("From s", value=0, min=0).props("dense outlined")
            self.end = ui.number("To s", value=round(self.duration_s, 2)).props("dense outlined")
        with ui.element("div").classes("zb-row"):
            save = ui.button("CSV", icon="download", on_click=with_errors_shown(self.save_csv))
            save.props("outline dense")
            video = ui.button("Video", icon="movie", on_click=with_errors_shown(self.save_video))
            video.props("outline dense")
            video.bind_enabled_from(self.topic, "value", self.has_images)

    def curves(self) -> list[str]:
        """Return the numeric fields of all topics."""
        found = []
        for information in self.metadata.topics if self.metadata else ():
            try:
                fields = fields_of(information.topic.type_name, only_numbers=True)
            except ZbotError:
                continue  # the type's definition is only in the bag, or it is wrong on this machine
            found += [f"{information.topic.name}.{field}" for field in fields]
        return found

    def has_images(self, topic: str | None) -> bool:
        """Return whether a topic can be exported as a video."""
        topics = self.metadata.topics if self.metadata else ()
        return any(
            information.topic.name == topic and information.topic.type_name in IMAGE_TYPES
            for information in topics
        )

    def update(self) -> None:
        """Show the state of the player."""
        news = self.end_notice.news()
        if news:
            with self.body:
                tell_end(news)
        player = self.player
        is_running = player is not None and not player.is_paused
        self.play_button.props(f"icon={'pause' if is_running else 'play_arrow'}")
        if player is not None and self.chosen_s is None:
            seconds = (player.position_ns - player.bag_start_ns) / S_TO_NS
            self.slider.set_value(round(max(seconds, 0.0), 2))
        letter = player.status if player is not None else PlayerStatus.STOPPED
        state = {PlayerStatus.RUNNING: "plays", PlayerStatus.PAUSED: "paused"}.get(letter, "")
        self.time.set_text(f"{self.slider.value:.2f} / {self.duration_s:.2f} s {state}")

    async def play(self) -> None:
        """Play, pause or resume."""
        self.control.check_player()
        player = self.player
        if player is not None:
            player.toggle_paused()
            return
        offset_s = float(self.slider.value or 0)
        if offset_s >= self.duration_s - _STEP_S:
            offset_s = 0.0
        chosen = [name for name, box in self.boxes.items() if box.value]
        topics = None if len(chosen) == len(self.boxes) else chosen
        words = [] if topics is None else ["--topics", *topics]
        if offset_s:
            words += ["--start-offset", f"{offset_s:g}"]
        if self.rate.value != 1:
            words += ["--rate", f"{self.rate.value:g}"]
        self.section.page.show_command(command_line("bag", "play", self.name, *words))
        play = partial(self.control.play, offset_s=offset_s, rate=self.rate.value, topics=topics)
        try:
            await run_in_thread(play, self.name)
        except ZbotError:
            self.end_notice.skip()
            raise

    async def step(self) -> None:
        """Start or pause the playback. If it is paused already, publish the next message."""
        self.control.check_player()
        player = self.player
        if player is None:
            await self.play()
        elif not player.is_paused:
            player.pause()
        else:
            player.play_next()

    async def stop(self) -> None:
        """End the playback."""
        await run_in_thread(self.control.stop_playing)
        self.slider.set_value(0)

    def change_rate(self, event: Any) -> None:
        """Change the speed of a running playback."""
        player = self.player
        if player is not None and not self.section.page.read_only:
            player.set_rate(float(event.value))

    def choose(self, event: Any) -> None:
        """Note where the user holds the timeline. Meanwhile, `update` does not move it."""
        self.chosen_s = float(event.args)

    async def seek(self, _event: object) -> None:
        """Move the playback to the time that the user has chosen on the timeline."""
        chosen_s, self.chosen_s = self.chosen_s, None
        if chosen_s is not None:
            self.control.seek(self.name, chosen_s)

    async def draw(self, event: Any) -> None:
        """Read the chosen curves from the bag, and draw them without a playback."""
        names = list(event.value or ())
        self.curve.props("loading")
        try:
            series = await self.chosen_curves.choose(names)
        except ZbotError:
            self.curve.props(remove="loading")
            raise
        if series is None:
            return  # the user has chosen others meanwhile, which are loading
        self.curve.props(remove="loading")
        self.chart.set_visibility(bool(names))
        self.chart.options.clear()
        self.chart.options.update(_chart(series, self.duration_s))
        self.chart.update()

    def read_curve(self, name: str) -> dict[str, Any]:
        """Return a curve for the chart."""
        topic, field = self.split(name)
        times, columns = topic_columns(self.control.path(self.name), topic, [field])
        values = columns[field]
        if not all(isinstance(value, int | float) for value in values):
            raise ViewerError(f"{name} cannot be plotted: its values are not single numbers")
        start_ns = self.metadata.start_ns if self.metadata else 0
        seconds = [(time_ns - start_ns) / S_TO_NS for time_ns in times]
        return {"name": name, "data": thinned(seconds, values, _PLOT_POINTS)}

    def split(self, name: str) -> tuple[str, str]:
        """Return the topic and the field of a curve."""
        topic = max((topic for topic in self.boxes if name.startswith(f"{topic}.")), key=len)
        return topic, name[len(topic) + 1 :]

    async def save_csv(self) -> None:
        """Send a part of a topic as CSV to the browser."""
        await self.save(export_csv, "csv", "text/csv")

    async def save_video(self) -> None:
        """Send the images in a part as a video to the browser."""
        await self.save(export_video, "avi", "video/x-msvideo")

    async def save(self, export: Export, suffix: str, media_type: str) -> None:
        """Convert the chosen part of the chosen topic with `export`. Send it to the browser."""
        topic = str(self.topic.value)
        start_ns = self.metadata.start_ns if self.metadata else 0
        part = (
            start_ns + int((self.start.value or 0) * S_TO_NS),
            start_ns + int(((self.end.value or 0) + _STEP_S) * S_TO_NS),
        )
        target, page = new_export_file(), self.section.page
        # The file is removed at the latest when the process ends, also by Ctrl-C.
        remove = page.on_close(finalize(page, _remove, target))
        try:
            bag = self.control.path(self.name)
            await run_in_thread(write_export, target, export, bag, topic, part, threads=EXPORTING)
        except BaseException:
            remove()
            raise
        if target.is_file():  # otherwise the page was closed meanwhile
            # The browser loads it with HTTP. In the websocket, other messages would wait for it.
            name = topic.strip("/").replace("/", "_")
            ui.download.file(target, f"{self.name}_{name}.{suffix}", media_type)


def tell_end(news: str) -> None:
    """Show the end of a recording or a playback until the user closes the message."""
    ui.notify(news, type="negative", timeout=0, close_button=True, multi_line=True)


def _remove(path: Path) -> None:
    with contextlib.suppress(OSError):  # on Windows, a file that a browser loads now stays
        path.unlink()


def _chart(series: list[dict[str, Any]], duration_s: float) -> dict[str, Any]:
    return {
        "animation": False,
        "grid": {"left": 14, "right": 22, "top": 34, "bottom": 34, "containLabel": True},
        "legend": {"type": "scroll", "top": 0},
        "tooltip": {"trigger": "axis", "renderMode": "richText"},
        "xAxis": {"type": "value", "min": 0, "max": round(max(duration_s, _STEP_S), 2)},
        "yAxis": {"type": "value", "scale": True},
        "dataZoom": [
            {"type": "inside", "filterMode": "none"},
            {"type": "slider", "height": 16, "bottom": 4},
        ],
        "series": [
            {"type": "line", "showSymbol": False, "emphasis": {"disabled": True}, **line}
            for line in series
        ],
    }
