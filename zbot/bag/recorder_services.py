"""Services and events of a recorder's node, with the names of rosbag2."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from pathlib import Path

    from zbot.bag.recorder import Recorder
    from zbot.node.node import Node


class RecorderServices:
    """Services `~/pause`, `~/resume`, `~/is_paused`, `~/split_bagfile` and `~/snapshot`.

    The node also publishes on `events/write_split` when a file of the bag is complete.

    Args:
        node: The recorder's node. Its executor runs the services.
        recorder: The recorder.
    """

    def __init__(self, node: Node, recorder: Recorder) -> None:
        from rosbag2_interfaces import msg, srv  # noqa: PLC0415 - the import makes the classes

        self._name = node.get_fully_qualified_name()
        self._recorder = recorder
        self._event_class: Any = msg.WriteSplitEvent
        self._splits = node.create_publisher(self._event_class, "events/write_split", 1)
        node.create_service(srv.Pause, "~/pause", self._pause)
        node.create_service(srv.Resume, "~/resume", self._resume)
        node.create_service(srv.IsPaused, "~/is_paused", self._is_paused)
        node.create_service(srv.SplitBagfile, "~/split_bagfile", self._split)
        if recorder.takes_snapshots:
            node.create_service(srv.Snapshot, "~/snapshot", self._snapshot)

    def announce_split(self, closed: Path, opened: Path) -> None:
        """Publish that a file is complete."""
        self._splits.publish(
            self._event_class(
                closed_file=str(closed), opened_file=str(opened), node_name=self._name
            )
        )

    def _pause(self, request: Any, response: Any) -> Any:  # noqa: ARG002 - rclpy's signature
        self._recorder.pause()
        return response

    def _resume(self, request: Any, response: Any) -> Any:  # noqa: ARG002 - as above
        self._recorder.resume()
        return response

    def _is_paused(self, request: Any, response: Any) -> Any:  # noqa: ARG002 - as above
        response.paused = self._recorder.is_paused
        return response

    def _split(self, request: Any, response: Any) -> Any:  # noqa: ARG002 - as above
        self._recorder.split()
        return response

    def _snapshot(self, request: Any, response: Any) -> Any:  # noqa: ARG002 - as above
        response.success = self._recorder.take_snapshot()
        return response
