"""Panel of bags: it records topics, lists recordings, and plays, plots and exports them."""

from __future__ import annotations

import time
from datetime import datetime
from typing import TYPE_CHECKING

from nicegui import ui

from zbot.bag.packages import import_mcap
from zbot.errors import ZbotError
from zbot.names import is_hidden
from zbot.observer.value_text import amount
from zbot.time import S_TO_NS
from zbot.web.page.command_line import command_line
from zbot.web.page.list_panel import ListPanel
from zbot.web.page.panel import Page, Panel
from zbot.web.page.repeated_reading import RepeatedReading
from zbot.web.page.service_call import run_in_thread, with_errors_shown
from zbot.web.page.table import Cell, Column
from zbot.web.panels.bags.bag_control import FoundBag, control_of
from zbot.web.panels.bags.bag_details import BagDetails, tell_end
from zbot.web.panels.bags.end_notice import EndNotice

if TYPE_CHECKING:
    from zbot.graph.snapshot import Snapshot

_HZ = 1.0
_STATE_HZ = 4.0
_COLUMNS = (
    Column("Bag", "zb-mono zb-cut"),
    Column("Start", "zb-cut zb-spare zb-wide", "170px"),
    Column("Duration", "zb-number zb-wide", "90px"),
    Column("Messages", "zb-number", "92px"),
    Column("Size", "zb-number zb-wide", "88px"),
)


class _Bags:
    def __init__(self, page: Page) -> None:
        self.page = page
        self.control = control_of(page.system)
        self.end = EndNotice("recording", lambda: self.control.recording)
        self.found: RepeatedReading[dict[str, FoundBag]]
        self.found = RepeatedReading(page, self.control.bags, {}, max_hz=_HZ)
        with ui.element("div").classes("zb-fill zb-bags"):
            self.state = ui.element("div").classes("zb-row zb-card zb-recording")
            with self.state:
                ui.icon("fiber_manual_record").classes("zb-bad")
                self.state_text = ui.label().classes("zb-grow")
                stop = ui.button("Stop", icon="stop", on_click=with_errors_shown(self.stop))
                stop.props("unelevated dense")
            self.state.set_visibility(False)
            with ui.element("div").classes("zb-grow zb-below"):
                ListPanel(
                    page,
                    columns=_COLUMNS,
                    rows=self.rows,
                    details=lambda section, key: BagDetails(section, self.control, key),
                    key="bag",
                    command="zbot bag info",
                    empty=f"No bag in {self.control.folder.name} yet: press Record",
                    hidden="Damaged bags",
                    version=lambda: self.found.number,
                )
        with page.toolbar:
            self.button = ui.button("Record", icon="fiber_manual_record", on_click=self.ask)
            self.button.props("unelevated dense")
            self.button.set_visibility(not page.read_only)
        page.live(self.show_state, _STATE_HZ)

    def rows(self, _graph: Snapshot, hidden: bool) -> dict[str, list[str | Cell]]:
        return {
            name: _row(bag)
            for name, bag in self.found.value.items()
            if bag.metadata is not None or hidden
        }

    def show_state(self) -> None:
        """Show how large the recording is, and how much room the disk has."""
        recording = self.control.recording
        is_running = recording is not None and recording.is_running
        self.state.set_visibility(is_running)
        self.button.set_enabled(not is_running)
        news = self.end.news()
        if news:
            with self.button:
                tell_end(news)
        if recording is None or not is_running:
            return
        seconds = time.monotonic() - recording.started_s
        text = f"{recording.path.name}: {seconds:.0f} s, {amount(recording.bytes, 'B') or '0 B'}"
        free = self.control.free_bytes()
        text += "" if free is None else f", {amount(free, 'B')} free on the disk"
        losses = recording.recorder.losses.list() if recording.recorder is not None else ""
        self.state_text.set_text(f"{text}; lost: {losses}" if losses else text)

    def ask(self) -> None:
        """Ask for the name of the bag and the topics."""
        topics = [name for name, _ in self.page.system.snapshot().topics() if not is_hidden(name)]
        with ui.dialog() as dialog, ui.card().classes("zb-dialog"):
            ui.label("Record topics").classes("zb-heading")
            name = ui.input("Name", value=f"{datetime.now():bag_%Y_%m_%d-%H_%M_%S}")
            name.props('dense outlined aria-label="Name of the bag"').classes("zb-grow")
            every = ui.checkbox("All topics, also later ones", value=True).props("dense")
            with ui.element("div").classes("zb-col zb-topic-choice") as choice:
                boxes = {topic: ui.checkbox(topic, value=True).props("dense") for topic in topics}
            choice.bind_visibility_from(every, "value", lambda value: not value)

            async def begin() -> None:
                chosen = (
                    None if every.value else [topic for topic, box in boxes.items() if box.value]
                )
                await self.record(name.value or "", chosen)
                dialog.close()

            with ui.element("div").classes("zb-row"):
                ui.button("Start", on_click=with_errors_shown(begin)).props("unelevated dense")
                ui.button("Cancel", on_click=dialog.close).props("outline dense")
        dialog.on("hide", dialog.delete)  # a closed dialog would stay in the browser
        dialog.open()

    async def record(self, name: str, topics: list[str] | None) -> None:
        words = ["-a"] if topics is None else ["--topics", *topics]
        self.page.show_command(command_line("bag", "record", "-o", name, *words))
        try:
            await run_in_thread(self.control.record, name, topics)
        except ZbotError:
            self.end.skip()
            raise

    async def stop(self) -> None:
        await run_in_thread(self.control.stop_recording)  # `show_state` tells an error


def _row(bag: FoundBag) -> list[str | Cell]:
    if bag.metadata is None:
        return [bag.name, Cell(bag.problem, "zb-warn", hint=bag.problem), "", "", ""]
    return [
        Cell(bag.name, hint=bag.problem or bag.name),
        date_text(bag.metadata.start_ns) if bag.metadata.message_count else "",
        f"{bag.metadata.duration_ns / S_TO_NS:.1f} s",
        str(bag.metadata.message_count),
        amount(bag.metadata.bag_size, "B"),
    ]


def date_text(time_ns: int) -> str:
    """Return the date of a bag, or an empty text if no date has this year."""
    try:
        start = datetime.fromtimestamp(time_ns / 1e9).astimezone()
    except (ValueError, OverflowError, OSError):
        return ""
    return f"{start:%Y-%m-%d %H:%M:%S}"


def _build(page: Page) -> None:
    try:
        import_mcap()
    except ZbotError as error:
        ui.label(str(error)).classes("zb-empty")
        return
    _Bags(page)


PANEL = Panel("/bags", "Bags", "inventory_2", _build)
