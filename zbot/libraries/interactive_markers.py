"""Markers that a user can move in RViz, and their menus: ROS 2's package `interactive_markers`."""

from __future__ import annotations

import copy
import threading
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from zbot.qos import QoSProfile
from zbot.time import S_TO_NS

from builtin_interfaces.msg import Time
from visualization_msgs.msg import (
    InteractiveMarker,
    InteractiveMarkerFeedback,
    InteractiveMarkerPose,
    InteractiveMarkerUpdate,
    MenuEntry,
)
from visualization_msgs.srv import GetInteractiveMarkers

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.node.node import Node

    from geometry_msgs.msg import Pose
    from std_msgs.msg import Header

    #: Function that gets the feedback of a user.
    Callback = Callable[[InteractiveMarkerFeedback], Any]

_TURN_NS = S_TO_NS  # for so long, only the client that moved a marker last may move it
_UPDATE_QOS, _FEEDBACK_QOS = QoSProfile(depth=100), QoSProfile(depth=1)


@dataclass
class _Marker:
    """Marker with its callbacks, by the type of feedback."""

    marker: InteractiveMarker
    callbacks: dict[int, Callback] = field(default_factory=dict)
    client: str = ""  #: the client that gave the last feedback
    used_ns: int = 0  #: when it gave the feedback


class InteractiveMarkerServer:
    """Shows markers to RViz, and calls functions when a user moves or clicks a marker.

    Changes of markers become visible when `applyChanges` is called. All methods may be called from
    any thread.

    Args:
        node: The node, whose executor calls the functions.
        namespace: The first part of the names of topics and service.
        update_pub_qos: The profile of the topic with changes.
        feedback_sub_qos: The profile of the topic with feedback.
    """

    DEFAULT_FEEDBACK_CALLBACK = 255

    def __init__(
        self,
        node: Node,
        namespace: str,
        *,
        update_pub_qos: QoSProfile = _UPDATE_QOS,
        feedback_sub_qos: QoSProfile = _FEEDBACK_QOS,
    ) -> None:
        self.node, self.namespace = node, namespace
        self.seq_num = 0
        self._lock = threading.RLock()
        self._shown: dict[str, _Marker] = {}
        # What the next `applyChanges` publishes: whole markers, poses, and None for erased markers.
        self._pending: dict[str, InteractiveMarker | InteractiveMarkerPose | None] = {}
        self._new: dict[str, _Marker] = {}  # markers that were never shown
        self._service = node.create_service(
            GetInteractiveMarkers, f"{namespace}/get_interactive_markers", self._on_request
        )
        self._publisher = node.create_publisher(
            InteractiveMarkerUpdate, f"{namespace}/update", update_pub_qos
        )
        self._subscription = node.create_subscription(
            InteractiveMarkerFeedback,
            f"{namespace}/feedback",
            self.processFeedback,
            feedback_sub_qos,
        )
        self._is_open = True

    def shutdown(self) -> None:
        """Erase all markers, and remove the topics and the service. It may be called twice."""
        if not self._is_open:
            return
        self._is_open = False
        if self.node.context.ok():
            self.clear()
            self.applyChanges()
        self.node.destroy_service(self._service)
        self.node.destroy_publisher(self._publisher)
        self.node.destroy_subscription(self._subscription)

    def insert(
        self,
        marker: InteractiveMarker,
        *,
        feedback_callback: Callback | None = None,
        feedback_type: int = DEFAULT_FEEDBACK_CALLBACK,
    ) -> None:
        """Add a marker, or replace the marker of the same name.

        Args:
            marker: The marker.
            feedback_callback: A function for `setCallback`.
            feedback_type: The type of feedback for this function.
        """
        with self._lock:
            self._pending[marker.name] = marker
            if marker.name not in self._shown and marker.name not in self._new:
                self._new[marker.name] = _Marker(marker)
        if feedback_callback is not None:
            self.setCallback(marker.name, feedback_callback, feedback_type)

    def setCallback(
        self,
        name: str,
        feedback_callback: Callback | None,
        feedback_type: int = DEFAULT_FEEDBACK_CALLBACK,
    ) -> bool:
        """Set the function that gets the feedback for a marker, or remove it with None.

        Args:
            name: The marker.
            feedback_callback: The function.
            feedback_type: A constant of `InteractiveMarkerFeedback`. The default is all types that
                have no function of their own.

        Returns:
            Whether there is such a marker.
        """
        with self._lock:
            known = self._known(name)
            if known is None:
                return False
            if feedback_callback is None:
                known.callbacks.pop(feedback_type, None)
            else:
                known.callbacks[feedback_type] = feedback_callback
            return True

    def _known(self, name: str) -> _Marker | None:
        return self._shown.get(name) or self._new.get(name)

    def setPose(self, name: str, pose: Pose, header: Header | None = None) -> bool:
        """Move a marker. An empty header keeps the marker's header.

        Return whether the marker was moved. A marker that waits for `applyChanges` as a whole is
        not moved.
        """
        with self._lock:
            shown = self._shown.get(name)
            is_erased = name in self._pending and self._pending[name] is None
            if shown is None or is_erased or isinstance(self._pending.get(name), InteractiveMarker):
                return False
            is_kept = header is None or not header.frame_id
            header = shown.marker.header if is_kept or header is None else header
            self._pending[name] = InteractiveMarkerPose(header=header, pose=pose, name=name)
            return True

    def erase(self, name: str) -> bool:
        """Remove a marker. Return whether there is such a marker."""
        with self._lock:
            if self._known(name) is None:
                return False
            self._pending[name] = None
            self._new.pop(name, None)
            return True

    def clear(self) -> None:
        """Remove all markers."""
        with self._lock:
            self._new.clear()
            self._pending = dict.fromkeys(self._shown)

    def applyChanges(self) -> None:
        """Publish all changes since the last call."""
        with self._lock:
            if not self._pending:
                return
            update = InteractiveMarkerUpdate(type=InteractiveMarkerUpdate.UPDATE)
            for name, change in self._pending.items():
                self._apply(name, change, update)
            self._pending = {}
            self.seq_num += 1
            update.seq_num = self.seq_num
            self._publisher.publish(update)

    def _apply(
        self,
        name: str,
        change: InteractiveMarker | InteractiveMarkerPose | None,
        update: InteractiveMarkerUpdate,
    ) -> None:
        if isinstance(change, InteractiveMarker):
            shown = self._shown.setdefault(name, self._new.pop(name, _Marker(change)))
            shown.marker = change
            update.markers.append(change)
        elif isinstance(change, InteractiveMarkerPose):
            marker = self._shown[name].marker
            marker.pose, marker.header = change.pose, change.header
            update.poses.append(change)
        elif self._shown.pop(name, None) is not None:
            update.erases.append(name)

    def get(self, name: str) -> InteractiveMarker | None:
        """Return a marker with its pending changes, or None if there is no such marker."""
        with self._lock:
            if name not in self._pending:
                return self._shown[name].marker if name in self._shown else None
            change = self._pending[name]
            if not isinstance(change, InteractiveMarkerPose):
                return change
            marker = copy.copy(self._shown[name].marker)
            marker.pose, marker.header = change.pose, change.header
            return marker

    def processFeedback(self, feedback: InteractiveMarkerFeedback) -> None:
        """Move the marker as the user has moved it, and call the function for the feedback."""
        with self._lock:
            shown = self._shown.get(feedback.marker_name)
            now_ns = self.node.get_clock().now().nanoseconds
            if shown is None or not self._is_in_turn(shown, feedback.client_id, now_ns):
                return
            shown.client, shown.used_ns = feedback.client_id, now_ns
            if feedback.event_type == InteractiveMarkerFeedback.POSE_UPDATE:
                # Without a time stamp, the marker is fixed in its frame: the header stays.
                is_fixed = shown.marker.header.stamp == Time()
                header = shown.marker.header if is_fixed else feedback.header
                self.setPose(feedback.marker_name, feedback.pose, header)
            default = shown.callbacks.get(self.DEFAULT_FEEDBACK_CALLBACK)
            callback = shown.callbacks.get(feedback.event_type, default)
        if callback is not None:
            callback(feedback)
        self.applyChanges()

    def _is_in_turn(self, shown: _Marker, client: str, now_ns: int) -> bool:
        return shown.client in {"", client} or now_ns - shown.used_ns >= _TURN_NS

    def _on_request(
        self, request: GetInteractiveMarkers.Request, response: GetInteractiveMarkers.Response
    ) -> GetInteractiveMarkers.Response:
        del request
        with self._lock:
            response.sequence_number = self.seq_num
            response.markers = [shown.marker for shown in self._shown.values()]
        return response


@dataclass
class _Entry:
    """Line of a menu."""

    title: str
    command: str
    command_type: int
    callback: Callback | None
    parent: int = 0
    visible: bool = True
    check_state: int = 0


class MenuHandler:
    """Menu of markers, and the functions of its entries. An entry is named by a number."""

    NO_CHECKBOX = 0
    CHECKED = 1
    UNCHECKED = 2

    def __init__(self) -> None:
        self._entries: dict[int, _Entry] = {}
        self._markers: list[str] = []

    def insert(
        self,
        title: str,
        parent: int | None = None,
        command_type: int = MenuEntry.FEEDBACK,
        command: str = "",
        callback: Callback | None = None,
    ) -> int | None:
        """Add an entry, and return its number.

        Args:
            title: The text.
            parent: The entry under which the new entry is. None means the first level.
            command_type: A constant of `MenuEntry`.
            command: A command for RViz.
            callback: Function that gets the feedback when the user selects the entry.

        Returns:
            The number. None if there is no such parent.
        """
        if parent is not None and parent not in self._entries:
            return None
        handle = len(self._entries) + 1
        self._entries[handle] = _Entry(title, command, command_type, callback, parent or 0)
        return handle

    def setVisible(self, handle: int, visible: bool) -> bool:
        """Show or hide an entry and all entries under it. Return whether there is such an entry."""
        return self._set(handle, "visible", visible)

    def setCheckState(self, handle: int, check_state: int) -> bool:
        """Set `NO_CHECKBOX`, `CHECKED` or `UNCHECKED`. Return whether there is such an entry."""
        return self._set(handle, "check_state", check_state)

    def _set(self, handle: int, name: str, value: Any) -> bool:
        if handle not in self._entries:
            return False
        setattr(self._entries[handle], name, value)
        return True

    def getCheckState(self, handle: int) -> int | None:
        """Return the state of an entry, or None if there is no such entry."""
        entry = self._entries.get(handle)
        return None if entry is None else entry.check_state

    def getTitle(self, handle: int) -> str | None:
        """Return the text of an entry, or None if there is no such entry."""
        entry = self._entries.get(handle)
        return None if entry is None else entry.title

    def apply(self, server: InteractiveMarkerServer, marker_name: str) -> bool:
        """Give the menu to a marker. Return whether there is such a marker."""
        marker = server.get(marker_name)
        if marker is None:
            if marker_name in self._markers:
                self._markers.remove(marker_name)
            return False
        marker.menu_entries = self._messages(0)
        kind = InteractiveMarkerFeedback.MENU_SELECT
        server.insert(marker, feedback_callback=self.processFeedback, feedback_type=kind)
        if marker_name not in self._markers:
            self._markers.append(marker_name)
        return True

    def reApply(self, server: InteractiveMarkerServer) -> bool:
        """Give the changed menu to all markers that have it. Return whether all of them exist."""
        applied = [self.apply(server, name) for name in list(self._markers)]
        return all(applied)

    def processFeedback(self, feedback: InteractiveMarkerFeedback) -> None:
        """Call the function of the entry that the user has selected."""
        entry = self._entries.get(feedback.menu_entry_id)
        if entry is not None and entry.callback is not None:
            entry.callback(feedback)

    def _messages(self, parent: int) -> list[MenuEntry]:
        """Return the visible entries under an entry, each before the entries under it."""
        boxes = {self.CHECKED: "[x] ", self.UNCHECKED: "[ ] "}
        found = []
        for handle, entry in self._entries.items():
            if entry.parent == parent and entry.visible:
                message = MenuEntry(id=handle, parent_id=parent, command=entry.command)
                message.title = boxes.get(entry.check_state, "") + entry.title
                message.command_type = entry.command_type
                found += [message, *self._messages(handle)]
        return found
