"""Panel of a classroom, with a card for each student and the chosen student's graph."""

from __future__ import annotations

import base64
import time
from typing import TYPE_CHECKING, Any, NamedTuple

from nicegui import background_tasks, ui

from zbot.classroom.teacher import opening
from zbot.classroom.teacher.invitation import Invitation, invitation
from zbot.errors import ZbotError, counted
from zbot.graph.diagram import draw
from zbot.graph.snapshot import Snapshot
from zbot.graph.view import limited, view
from zbot.text.whole_number import whole_number
from zbot.web.page.panel import Page, Panel
from zbot.web.page.qr_code import qr_code
from zbot.web.page.service_call import DRAWING, run_in_thread

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.graph.view import GraphView


# Seconds from the classroom's last answer to the next query.
_PERIOD_S = 1.0
_DRAW_HZ = 4.0
_SECONDS_OF = {"s": 60.0, "min": 60.0, "h": 24.0, "d": float("inf")}

Student = dict[str, Any]


class _Picture(NamedTuple):
    """Drawing of a student's graph."""

    view: GraphView
    address: str  #: the address for the browser


class _Card:
    """Card of one student."""

    def __init__(self, choose: Callable[[], None]) -> None:
        self.element = ui.element("div").classes("zb-card zb-student")
        self.element.props('role="button" tabindex="0"')
        self.element.on("click", choose).on("keydown.enter", choose)
        with self.element:
            with ui.element("div").classes("zb-row"):
                self.number = ui.label().classes("zb-student-number")
                self.name = ui.label().classes("zb-grow zb-cut")
                self.state = ui.label().classes("zb-muted")
            self.facts = ui.label().classes("zb-muted zb-cut")
            self.error = ui.label().classes("zb-bad zb-cut")

    def show(self, student: Student, *, is_chosen: bool) -> None:
        """Show a student's present state. Unchanged text is not sent again."""
        error, here = student["last_error"], student["here"]
        self.number.set_text(str(student["number"]))
        self.name.set_text(student["name"])
        self.state.set_text(_nodes(student) if here else _absence(student))
        self.facts.set_text(_facts(student))
        self.error.set_text(f"{error['node']}: {error['text']}" if error else "")
        for name, is_on in (("zb-student-lost", not here), ("zb-student-chosen", is_chosen)):
            self.element.classes(**({"add": name} if is_on else {"remove": name}))


class _Class:
    """Cards of all students in the classroom, with a graph below the cards."""

    def __init__(self, page: Page) -> None:
        self.page = page
        self.chosen = whole_number(page.query.get("student", ""), 8)
        self.found: Student | None = None
        self.invited: Invitation | None = None
        self.graph: _Picture | None = None
        self.problem = ""
        self.asked_s = 0.0
        self.is_asking = False
        self.cards: dict[int, _Card] = {}
        self.drawn: _Picture | None = None
        with page.toolbar:
            self.count = ui.label().classes("zb-muted")
        with ui.element("div").classes("zb-col"):
            self.invitation = ClassInvitation(page) if page.is_local else None
            self.empty = ui.label().classes("zb-empty")
            self.grid = ui.element("div").classes("zb-students")
            with ui.element("div").classes("zb-row"):
                self.heading = ui.label().classes("zb-heading")
                self.view = ui.element("a").classes("zb-student-view").props("target=_blank")
                with self.view:
                    ui.label("Open the 3D view")
            self.picture = ui.element("img").props('alt="The student\'s graph"')
        self.choose(self.chosen)
        page.live(self.update, _DRAW_HZ)

    def update(self) -> None:
        """Show the last answer, and query the classroom again if it is time."""
        if not self.is_asking and time.monotonic() - self.asked_s > _PERIOD_S:
            self.is_asking = True
            background_tasks.create(self.ask(), name="zbot class")
        self.show()

    async def ask(self) -> None:
        """Query the classroom in a thread, because the query may take a second."""
        chosen = self.chosen
        try:
            self.found, graph, self.invited = await run_in_thread(_look, chosen)
            self.problem = ""
            picture = await run_in_thread(_picture, graph, self.graph, threads=DRAWING)
            if chosen == self.chosen:
                self.graph = picture
        except ZbotError as error:
            self.found, self.invited, self.problem = None, None, str(error)
        finally:
            self.is_asking, self.asked_s = False, time.monotonic()

    def show(self) -> None:
        students = self.found["students"] if self.found else []
        self.empty.set_text(self.problem or ("" if students else "No student has joined yet"))
        self.empty.set_visibility(not students)
        here = sum(student["here"] for student in students)
        title = f"{self.found['class']}: {here} of {len(students)} here" if self.found else ""
        self.count.set_text(title)
        if self.invitation is not None:
            self.invitation.show(self.invited)
        for number in self.cards.keys() - {student["number"] for student in students}:
            self.cards.pop(number).element.delete()
        for student in students:
            number = student["number"]
            if number not in self.cards:
                self.cards[number] = self.new_card(number)
            self.cards[number].show(student, is_chosen=number == self.chosen)
        self.show_graph()

    def new_card(self, number: int) -> _Card:
        """Add a card in the order of the students' numbers, and return the card."""
        with self.grid:
            card = _Card(lambda: self.choose(number))
        card.element.move(target_index=sum(other < number for other in self.cards))
        return card

    def show_graph(self) -> None:
        """Show the chosen student's graph if it has changed."""
        is_shown = self.chosen in self.cards
        self.picture.set_visibility(is_shown and self.graph is not None)
        self.heading.set_text(f"Graph of {self.chosen}" if is_shown else "")
        self.view.set_visibility(is_shown)
        if is_shown and self.graph is not None and self.graph is not self.drawn:
            self.drawn = self.graph
            self.picture.props(f'src="{self.graph.address}"')

    def choose(self, number: int | None) -> None:
        """Show a student's graph, or no graph if `number` is None."""
        self.chosen, self.asked_s = number, 0.0
        self.view.props["href"] = f"/view?student={number}"
        self.view.update()
        self.graph = None
        if number is None:
            self.page.show_command("zbot class list")
        else:
            self.page.set_query(student=str(number))
            self.page.show_command(f"zbot graph /{number}")


def _look(chosen: int | None) -> tuple[Student, Snapshot, Invitation]:
    found = opening.command({"op": "list"})
    snapshot = opening.graph_of(chosen) if chosen is not None else Snapshot(())
    return found, snapshot, invitation()


def _picture(graph: Snapshot, before: _Picture | None) -> _Picture:
    """Return the drawing of a graph, or `before` if it is the same drawing."""
    shown = limited(view(graph))
    if before is not None and before.view == shown:
        return before
    # As an image, the SVG is safe: browsers run no script in an image, even if a node's name
    # contains a script.
    svg = draw(shown).svg().encode()
    return _Picture(shown, f"data:image/svg+xml;base64,{base64.b64encode(svg).decode()}")


def _nodes(student: Student) -> str:
    count = len(student["nodes"])
    if student["more_nodes"]:
        return f"more than {count} nodes"
    return counted(count, "node")


def _facts(student: Student) -> str:
    offset = student["clock_offset"]
    clock = f"clock {offset:+.2f} s" if offset is not None and abs(offset) > 0.1 else ""
    return ", ".join(filter(None, [student["host"], student["system"], clock]))


def _absence(student: Student) -> str:
    if not student["since"]:
        return "not seen yet"
    left = max(0.0, time.time() - student["since"])
    for unit, size in _SECONDS_OF.items():
        if left < size:
            return f"lost {left:.0f} {unit} ago"
        left /= size
    return "lost"


def _build(page: Page) -> None:
    _Class(page)


PANEL = Panel("/class", "Class", "school", _build)


class ClassInvitation:
    """Button in the toolbar, and the invitation that it shows.

    Only a browser on the teacher's machine shows the invitation, because it contains the PIN.

    Args:
        page: The page of the browser.
    """

    def __init__(self, page: Page) -> None:
        self._is_wanted = False
        self._shown: Invitation | None = None
        self._known: Invitation | None = None
        with page.toolbar:
            self._button = ui.button("Show the code", on_click=self._toggle)
            self._button.props("outline dense")
        self._card = ui.element("div").classes("zb-card zb-invitation")
        with self._card:
            self._picture = ui.element("img").props('alt="QR code of the command"')
            with ui.element("div").classes("zb-col"):
                self._command = ui.label().classes("zb-invitation-command")
                self._pin = ui.label().classes("zb-invitation-command")
                self._address = ui.label().classes("zb-muted")
        # The button is hidden until an invitation is known. Otherwise the button would appear,
        # disappear and appear again, and a fast click would be lost.
        self.show(None)

    def _toggle(self) -> None:
        self._is_wanted = not self._is_wanted
        self._button.set_text("Hide the code" if self._is_wanted else "Show the code")
        self.show(self._known)

    def show(self, invitation: Invitation | None) -> None:
        """Show an invitation if the user wants to see it. `None` means that no class is open."""
        self._known = invitation
        self._button.set_visibility(invitation is not None)
        self._card.set_visibility(self._is_wanted and invitation is not None)
        if invitation is None or invitation == self._shown:
            return
        self._shown = invitation
        self._command.set_text(invitation.command)
        self._pin.set_text(f"PIN {invitation.pin}" if invitation.pin else "")
        self._address.set_text(f"or: zbot join {invitation.address}")
        self._picture.props(f'src="{qr_code(f"zbot join {invitation.address}")}"')
