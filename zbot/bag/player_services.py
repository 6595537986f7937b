"""Services of a player's node, with the names of rosbag2."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.time import Time

if TYPE_CHECKING:
    from zbot.bag.player import Player
    from zbot.node.node import Node


class PlayerServices:
    """Services `~/pause`, `~/resume`, `~/seek` and others of a player.

    The others are `~/toggle_paused`, `~/is_paused`, `~/get_rate`, `~/set_rate`, `~/play`,
    `~/play_next`, `~/burst` and `~/stop`.

    Args:
        node: The player's node. Its executor runs the services, in another thread than `run`.
        player: The player.
    """

    def __init__(self, node: Node, player: Player) -> None:
        from rosbag2_interfaces import srv  # noqa: PLC0415 - the import makes the classes

        self._player = player
        commands = {
            (srv.Pause, "pause"): player.pause,
            (srv.Resume, "resume"): player.resume,
            (srv.TogglePaused, "toggle_paused"): player.toggle_paused,
            (srv.Stop, "stop"): player.stop,
        }
        for (kind, name), command in commands.items():
            node.create_service(kind, f"~/{name}", _without_fields(command))
        node.create_service(srv.IsPaused, "~/is_paused", self._is_paused)
        node.create_service(srv.GetRate, "~/get_rate", self._get_rate)
        node.create_service(srv.SetRate, "~/set_rate", self._set_rate)
        node.create_service(srv.Play, "~/play", self._play)
        node.create_service(srv.PlayNext, "~/play_next", self._play_next)
        node.create_service(srv.Burst, "~/burst", self._burst)
        node.create_service(srv.Seek, "~/seek", self._seek)

    def _is_paused(self, request: Any, response: Any) -> Any:  # noqa: ARG002 - rclpy's signature
        response.paused = self._player.is_paused
        return response

    def _get_rate(self, request: Any, response: Any) -> Any:  # noqa: ARG002 - as above
        response.rate = self._player.rate
        return response

    def _set_rate(self, request: Any, response: Any) -> Any:
        response.success = self._player.set_rate(request.rate)
        return response

    def _play(self, request: Any, response: Any) -> Any:  # noqa: ARG002 - as above
        response.success = False  # the node has these services only while it plays
        return response

    def _play_next(self, request: Any, response: Any) -> Any:  # noqa: ARG002 - as above
        response.success = self._player.burst(1) == 1
        return response

    def _burst(self, request: Any, response: Any) -> Any:
        response.actually_burst = self._player.burst(request.num_messages)
        return response

    def _seek(self, request: Any, response: Any) -> Any:
        response.success = self._player.seek(Time.from_msg(request.time).nanoseconds)
        return response


def _without_fields(command: Any) -> Any:
    def serve(request: Any, response: Any) -> Any:  # noqa: ARG001 - as above
        command()
        return response

    return serve
