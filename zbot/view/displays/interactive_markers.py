"""Display InteractiveMarkers: markers that a user moves, turns and clicks, with their menus."""

from __future__ import annotations

import contextlib
import os
import queue
import time
from typing import TYPE_CHECKING, Any, NamedTuple

from zbot.text.whole_number import whole_number
from zbot.tf2.rigid import Rigid, conjugate, multiply
from zbot.view.displays.display import Call, Display, Outgoing, Setting
from zbot.view.displays.marker import marker_shapes
from zbot.view.errors import DisplayError
from zbot.view.points import check_number
from zbot.view.pose import pose_of
from zbot.view.shape import Gizmo, Item, Label

from geometry_msgs.msg import Point, Pose
from visualization_msgs.msg import (
    InteractiveMarkerControl,
    InteractiveMarkerFeedback,
    InteractiveMarkerUpdate,
)
from visualization_msgs.srv import GetInteractiveMarkers

if TYPE_CHECKING:
    from collections.abc import Iterator

    from zbot.tf2.rigid import Vector
    from zbot.view.mesh_file import MeshFiles

_UPDATE = "/update"
_MOST_MARKERS = 500
_MOST_PARTS = 5000
_LONGEST_PAUSE_S = 10.0  #: between two movements of a user who holds a handle
_MOST_ENTRIES = 200
_MOST_LEVELS = 20
_ASK_PERIOD_S = 2.0
_FEEDBACK = "visualization_msgs/msg/InteractiveMarkerFeedback"
_SERVICE = "visualization_msgs/srv/GetInteractiveMarkers"
_CONTROL, _EVENT = InteractiveMarkerControl, InteractiveMarkerFeedback
_EVENTS = {"start": _EVENT.MOUSE_DOWN, "update": _EVENT.POSE_UPDATE, "end": _EVENT.MOUSE_UP}
_ALL, _ONE, _OTHERS = (True, True, True), (True, False, False), (False, True, True)
#: For each mode, what the user takes: the axes, and whether there are arrows, squares and rings.
_HANDLES = {
    _CONTROL.MOVE_AXIS: (_ONE, True, False, False),
    _CONTROL.MOVE_PLANE: (_OTHERS, False, True, False),
    _CONTROL.ROTATE_AXIS: (_OTHERS, False, False, True),
    _CONTROL.MOVE_ROTATE: (_OTHERS, False, True, True),
    _CONTROL.MOVE_3D: (_ALL, True, True, False),
    _CONTROL.ROTATE_3D: (_ALL, False, False, True),
    _CONTROL.MOVE_ROTATE_3D: (_ALL, True, True, True),
}


class _Drag(NamedTuple):
    """Movement of a handle by a user, in the coordinates in which the handle was before."""

    marker: str
    control: str
    phase: str
    by: Rigid


class InteractiveMarkers(Display):
    """Markers of an interactive marker server. What the user does is sent to the server."""

    name = "InteractiveMarkers"
    types = ("visualization_msgs/msg/InteractiveMarkerUpdate",)
    settings = (Setting("names", True), Setting("handles", True))
    kept = 100

    def __init__(self, topic: str, files: MeshFiles | None = None) -> None:
        super().__init__(topic, files)
        self._namespace = topic.removesuffix(_UPDATE)
        self._markers: dict[str, Any] = {}
        self._waiting: set[str] = set()  # markers whose files are being read
        self._drags: queue.SimpleQueue[_Drag] = queue.SimpleQueue()
        self._pending: list[_Drag] = []
        self._held = ("", "", Rigid(), Rigid())  # marker, control, its pose and the marker's before
        self._last = Rigid()  # movement of what is held
        self._dragged_s = 0.0
        self._number: int | None = None  # of the last update, or None before the first answer
        self._asked_s = 0.0
        self._menus: dict[str, dict[str, int]] = {}
        self._client = f"zbot view {os.getpid()}"
        self.outgoing.append(Outgoing(f"{self._namespace}/feedback", _FEEDBACK))

    # -- messages of the server ---------------------------------------------------------------

    def take(self, message: Any) -> None:
        """Take an update of the server, or its answer with all markers."""
        self.notice = ""
        try:
            self._take(message)
        finally:
            self.menus = {name: tuple(entries) for name, entries in self._menus.items()}

    def _take(self, message: Any) -> None:
        if isinstance(message, GetInteractiveMarkers.Response):
            self._number = message.sequence_number
            for name in [*self._markers]:
                self._forget(name)
            self._add(message.markers)
            return
        is_update = message.type == InteractiveMarkerUpdate.UPDATE
        number = message.seq_num - 1 if is_update else message.seq_num
        # After a missed update, and after another start of the server, ask again for all.
        self._number = message.seq_num if number == self._number else None
        for name in message.erases:
            self._forget(name)
        changed: dict[str, Any] = {}  # a message may move one marker often
        for moved in message.poses:
            known = self._markers.get(moved.name)
            if known is not None:
                known.header, known.pose = moved.header, moved.pose
                changed[moved.name] = known
        for known in changed.values():
            self._show(known)
        self._add(message.markers)

    def _add(self, markers: Any) -> None:
        mistakes = []
        for marker in markers:
            if marker.name not in self._markers and len(self._markers) >= _MOST_MARKERS:
                raise DisplayError(f"only the first {_MOST_MARKERS} interactive markers are shown")
            self._forget(marker.name)
            self._markers[marker.name] = marker
            try:
                self._show(marker)
            except DisplayError as error:
                self._forget(marker.name)
                mistakes.append(f"interactive marker {marker.name}: {error}")
            else:
                self._offer_menu(marker)
        if mistakes:
            raise DisplayError(mistakes[0])

    def _forget(self, name: str) -> None:
        marker = self._markers.pop(name, None)
        self._waiting.discard(name)
        self._menus.pop(name, None)
        for key in () if marker is None else _keys(marker):
            self.items.pop(key, None)

    def tick(self, now_ns: int) -> None:
        """Ask for the markers if necessary, and send what the user has done."""
        del now_ns
        for name in [*self._waiting]:
            self._show(self._markers[name])
        if self._pending or not self._drags.empty():
            self._drag(self._next_drag())
        now_s = time.monotonic()
        if self._held[0] and now_s - self._dragged_s > _LONGEST_PAUSE_S:
            self._drags.put(_Drag(*self._held[:2], "end", self._last))  # the browser is gone
        if self._number is None and now_s - self._asked_s > _ASK_PERIOD_S:
            self._asked_s = now_s
            service = f"{self._namespace}/get_interactive_markers"
            self.calls.append(Call(service, _SERVICE, GetInteractiveMarkers.Request()))

    def change(self, name: str, value: Any) -> None:
        """Change a setting."""
        super().change(name, value)
        self.items.clear()
        for marker in self._markers.values():
            with contextlib.suppress(DisplayError):  # it was named when it came
                self._show(marker)

    # -- what is shown ------------------------------------------------------------------------

    def _show(self, marker: Any) -> None:
        """Show a marker at its present pose. Shapes that are known stay."""
        frame = marker.header.frame_id.removeprefix("/")
        if not frame:
            raise DisplayError("it names no frame: its program must set header.frame_id")
        stamp = marker.header.stamp
        stamp_ns, pose = stamp.sec * 10**9 + stamp.nanosec, pose_of(marker.pose)
        self._waiting.discard(marker.name)
        if self.values["names"] and marker.description:
            height = (check_number(marker.scale, "scale", low=0) or 1.0) * 0.6
            key = f"{marker.name}/0/name"
            known = self.items.get(key)
            shapes = known.shapes if known else (Label(marker.description),)
            above = Rigid(pose.translation) @ Rigid((0.0, 0.0, height))
            self.items[key] = Item(frame, stamp_ns, shapes, above)
        for number in range(len(marker.controls)):
            self._show_control(marker, number, Item(frame, stamp_ns, (), pose))

    def _show_control(self, marker: Any, number: int, base: Item) -> None:
        control = marker.controls[number]
        for place, part in enumerate(control.markers):
            key = f"{marker.name}/{number}/{place}"
            known = self.items.get(key)
            shapes = known.shapes if known else marker_shapes(part, self.files)
            if shapes is None:
                self._waiting.add(marker.name)
                continue
            if known is None and len(self.items) >= _MOST_PARTS:
                raise DisplayError(f"only the first {_MOST_PARTS} parts are shown")
            own = part.header.frame_id.removeprefix("/")
            pose = pose_of(part.pose)
            placed = base._replace(frame=own) if own else base
            at = pose if own else base.pose @ pose
            self.items[key] = placed._replace(shapes=tuple(shapes), pose=at)
        handle = _HANDLES.get(control.interaction_mode)
        key = f"{marker.name}/{number}/handle"
        if handle is None or not self.values["handles"]:
            return
        if (marker.name, control.name) == self._held[:2]:
            return  # the user's browser moves it
        known = self.items.get(key)
        gizmo = known.shapes if known else (self._gizmo(marker, control, handle),)
        self.items[key] = base._replace(shapes=gizmo, pose=_pose_of_handle(base.pose, control))

    def _gizmo(self, marker: Any, control: Any, handle: Any) -> Gizmo:
        axes, has_arrows, has_squares, has_rings = handle
        scale = check_number(marker.scale, "scale", low=0) or 1.0

        def moved(phase: str, by: Rigid) -> None:
            self._drags.put(_Drag(marker.name, control.name, phase, by))

        return Gizmo(moved, axes, has_arrows, has_squares, has_rings, 0.75 * scale)

    # -- what the user does -------------------------------------------------------------------

    def _next_drag(self) -> _Drag:
        """Return the next movement that is told. Of successive updates, it is the last one.

        There is one for each drawing, because servers keep only one unread message.
        """
        self._pending += [self._drags.get() for _ in range(self._drags.qsize())]
        drag = self._pending.pop(0)
        while drag.phase == "update" and self._pending and self._pending[0].phase == "update":
            drag = self._pending.pop(0)
        return drag

    def _drag(self, drag: _Drag) -> None:
        marker = self._markers.get(drag.marker)
        controls = marker.controls if marker is not None else ()
        control = next((one for one in controls if one.name == drag.control), None)
        if marker is None or control is None:
            self._held = ("", "", Rigid(), Rigid())
            return
        self._dragged_s, self._last = time.monotonic(), drag.by
        before = pose_of(marker.pose)
        if drag.phase == "start" or self._held[:2] != (drag.marker, drag.control):
            self._held = (drag.marker, drag.control, _pose_of_handle(before, control), before)
        moved = self._held[2] @ drag.by
        turned = multiply(moved.rotation, conjugate(self._held[2].rotation))
        pose = Rigid(moved.translation, multiply(turned, self._held[3].rotation))
        _set_pose(marker.pose, pose)
        if drag.phase == "end":
            self._held = ("", "", Rigid(), Rigid())
            number = marker.controls.index(control)
            self.items.pop(f"{marker.name}/{number}/handle", None)  # a new one, where it is now
        self._show(marker)
        self._tell(marker, drag.control, _EVENTS[drag.phase])

    def press(self, name: str, place: Vector) -> str:
        """Click what has a name, at a place in its frame. Return a sentence about it."""
        marker_name, _, rest = name.rpartition("/")[0].rpartition("/")
        marker = self._markers.get(marker_name)
        number = whole_number(rest)
        if marker is None or number is None or number >= len(marker.controls):
            return ""
        control = marker.controls[number]
        if control.interaction_mode == _CONTROL.BUTTON:
            self._tell(marker, control.name, _EVENT.BUTTON_CLICK, place=place)
            return f"{marker.name} was clicked."
        if marker.menu_entries:
            return f"The menu of {marker.name} is in the list, below {self.topic}."
        return f"{marker.name} is no button. Drag its arrows and rings."

    def _offer_menu(self, marker: Any) -> None:
        titles = {entry.id: entry for entry in marker.menu_entries[:_MOST_ENTRIES]}
        parents = {entry.parent_id for entry in titles.values()}
        leaves = [entry for entry in titles.values() if entry.id not in parents]
        if leaves:
            self._menus[marker.name] = {_title(entry, titles): entry.id for entry in leaves}

    def choose(self, menu: str, entry: str) -> None:
        """Choose an entry of the menu of a marker."""
        marker, number = self._markers.get(menu), self._menus.get(menu, {}).get(entry)
        if marker is None or number is None:
            return
        names = [one.name for one in marker.controls if one.interaction_mode == _CONTROL.MENU]
        self._tell(marker, names[0] if names else "", _EVENT.MENU_SELECT, entry=number)

    def _tell(
        self, marker: Any, control: str, event: int, *, place: Vector | None = None, entry: int = 0
    ) -> None:
        """Send feedback to the server."""
        feedback = InteractiveMarkerFeedback(
            header=marker.header,
            client_id=self._client,
            marker_name=marker.name,
            control_name=control,
            event_type=event,
            pose=marker.pose,
            menu_entry_id=entry,
        )
        if place is not None:
            feedback.mouse_point = Point(x=place[0], y=place[1], z=place[2])
            feedback.mouse_point_valid = True
        self.outgoing.append(Outgoing(f"{self._namespace}/feedback", _FEEDBACK, feedback))


def _keys(marker: Any) -> Iterator[str]:
    """Yield the keys of all items that a marker may have."""
    yield f"{marker.name}/0/name"
    for number, control in enumerate(marker.controls):
        yield f"{marker.name}/{number}/handle"
        for place in range(len(control.markers)):
            yield f"{marker.name}/{number}/{place}"


def _pose_of_handle(pose: Rigid, control: Any) -> Rigid:
    """Return the pose of a control's handle: the axis of a control is its x."""
    turn = pose_of(Pose(orientation=control.orientation)).rotation
    if control.orientation_mode == _CONTROL.FIXED:
        return Rigid(pose.translation, turn)
    return pose @ Rigid(rotation=turn)


def _set_pose(message: Any, pose: Rigid) -> None:
    place, turn = message.position, message.orientation
    place.x, place.y, place.z = pose.translation
    turn.x, turn.y, turn.z, turn.w = pose.rotation


def _title(entry: Any, titles: dict[int, Any]) -> str:
    """Return the titles on the way to an entry, e.g. `Size / Large`."""
    words, seen = [entry.title], {entry.id}
    while entry.parent_id in titles and entry.parent_id not in seen and len(seen) < _MOST_LEVELS:
        entry = titles[entry.parent_id]
        seen.add(entry.id)
        words.insert(0, entry.title)
    return " / ".join(words)
