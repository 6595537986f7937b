"""Requests to the services of Nav2: maps, costmaps and the states of its nodes."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING

from zbot.interfaces import type_name
from zbot.libraries.navigation.client import Nav2Client
from zbot.qos import DurabilityPolicy, QoSProfile
from zbot.runtime import spin_once, spin_until_future_complete

from geometry_msgs.msg import PoseStamped, PoseWithCovarianceStamped
from lifecycle_msgs.srv import GetState
from nav2_msgs import srv

if TYPE_CHECKING:
    from nav2_msgs.msg import Costmap

_POSE_S = 1.0  # between two messages with the initial pose
_STATE_S = 0.5  # between two questions for the state of a node
_KEPT = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
_MAP_ERRORS = {
    srv.LoadMap.Response.RESULT_MAP_DOES_NOT_EXIST: "Map does not exist",
    srv.LoadMap.Response.RESULT_INVALID_MAP_DATA: "Invalid map data",
    srv.LoadMap.Response.RESULT_INVALID_MAP_METADATA: "Invalid map metadata",
    srv.LoadMap.Response.RESULT_UNDEFINED_FAILURE: "Undefined failure",
}


class Nav2Services(Nav2Client):
    """Node that calls the services of Nav2. Each method waits until its service is there."""

    def __init__(self, node_name: str, namespace: str = "") -> None:
        super().__init__(node_name, namespace)
        self.localization_pose_sub = self.create_subscription(
            PoseWithCovarianceStamped, "amcl_pose", self._amclPoseCallback, _KEPT
        )
        self.initial_pose_pub = self.create_publisher(PoseWithCovarianceStamped, "initialpose", 10)

    # -- states of Nav2's nodes ----------------------------------------------------------------

    def waitUntilNav2Active(self, navigator: str = "bt_navigator", localizer: str = "amcl") -> None:
        """Wait until the nodes of Nav2 are active.

        Args:
            navigator: The node that plans and drives.
            localizer: The node that finds the place of the robot. For `amcl`, the initial pose is
                published until a pose comes back. `robot_localization` has no states.
        """
        if localizer != "robot_localization":
            self._waitForNodeToActivate(localizer)
        if localizer == "amcl":
            self._waitForInitialPose()
        self._waitForNodeToActivate(navigator)
        self.info("Nav2 is ready for use!")

    def _waitForNodeToActivate(self, node_name: str) -> None:
        self.debug(f"Waiting for {node_name} to become active..")
        name = f"{node_name}/get_state"
        client = self.create_client(GetState, name)
        while True:
            response = self._call(client, name, GetState.Request())
            state = "unknown" if response is None else response.current_state.label
            self.debug(f"Result of get_state: {state}")
            if state == "active":
                break
            time.sleep(_STATE_S)
        self.destroy_client(client)

    def setInitialPose(self, initial_pose: PoseStamped) -> None:
        """Tell the localizer where the robot is."""
        self.initial_pose_received = False
        self.initial_pose = initial_pose
        self._setInitialPose()

    def _setInitialPose(self) -> None:
        message = PoseWithCovarianceStamped(header=self.initial_pose.header)
        message.pose.pose = self.initial_pose.pose
        self.info("Publishing Initial Pose")
        self.initial_pose_pub.publish(message)

    def _waitForInitialPose(self) -> None:
        while not self.initial_pose_received:
            self.info("Setting initial pose")
            self._setInitialPose()
            self.info("Waiting for amcl_pose to be received")
            spin_once(self, timeout_sec=_POSE_S)

    def _amclPoseCallback(self, msg: PoseWithCovarianceStamped) -> None:  # noqa: ARG002 - a callback
        self.debug("Received amcl pose")
        self.initial_pose_received = True

    def lifecycleStartup(self) -> None:
        """Start all nodes of Nav2 by their lifecycle managers, and wait until they are active.

        The localizer cannot start without a pose, so the initial pose is published meanwhile.
        """
        self.info("Starting up lifecycle nodes based on lifecycle_manager.")
        self._manage(srv.ManageLifecycleNodes.Request.STARTUP, "Starting up")
        self.info("Nav2 is ready for use!")

    def lifecycleShutdown(self) -> None:
        """Shut down all nodes of Nav2 by their lifecycle managers."""
        self.info("Shutting down lifecycle nodes based on lifecycle_manager.")
        self._manage(srv.ManageLifecycleNodes.Request.SHUTDOWN, "Shutting down")

    def _manage(self, command: int, what: str) -> None:
        kind = type_name(srv.ManageLifecycleNodes)
        for name, types in self.get_service_names_and_types():
            if kind not in types:
                continue
            self.info(f"{what} {name}")
            client = self.create_client(srv.ManageLifecycleNodes, name)
            future = client.call_async(srv.ManageLifecycleNodes.Request(command=command))
            while not future.done():
                spin_until_future_complete(self, future, timeout_sec=_POSE_S)
                if command == srv.ManageLifecycleNodes.Request.STARTUP and not (
                    future.done() or self.initial_pose_received
                ):
                    self._setInitialPose()
            self._result_of(future)
            self.destroy_client(client)

    # -- maps and costmaps ---------------------------------------------------------------------

    def changeMap(self, map_filepath: str) -> bool:
        """Load another map. Return whether it was loaded."""
        request = srv.LoadMap.Request(map_url=map_filepath)
        response = self._call(self.change_maps_srv, "Change map", request)
        if response is None:
            return False
        if response.result == srv.LoadMap.Response.RESULT_SUCCESS:
            self.info("Change map request was successful!")
            return True
        reason = _MAP_ERRORS.get(response.result, "Unknown")
        self.setTaskError(response.result, reason)
        self.error(f"Change map request failed:{reason}!")
        return False

    def clearAllCostmaps(self) -> None:
        """Clear the local and the global costmap."""
        self.clearLocalCostmap()
        self.clearGlobalCostmap()

    def clearLocalCostmap(self) -> None:
        """Clear the local costmap."""
        request = srv.ClearEntireCostmap.Request()
        self._call(self.clear_costmap_local_srv, "Clear local costmap", request)

    def clearGlobalCostmap(self) -> None:
        """Clear the global costmap."""
        request = srv.ClearEntireCostmap.Request()
        self._call(self.clear_costmap_global_srv, "Clear global costmap", request)

    def clearCostmapExceptRegion(self, reset_distance: float) -> None:
        """Clear the local costmap farther than `reset_distance` metres from the robot."""
        request = srv.ClearCostmapExceptRegion.Request(reset_distance=float(reset_distance))
        self._call(self.clear_costmap_except_region_srv, "Clear costmap except region", request)

    def clearCostmapAroundRobot(self, reset_distance: float) -> None:
        """Clear the local costmap within `reset_distance` metres of the robot."""
        request = srv.ClearCostmapAroundRobot.Request(reset_distance=float(reset_distance))
        self._call(self.clear_costmap_around_robot_srv, "Clear costmap around robot", request)

    def clearLocalCostmapAroundPose(self, pose: PoseStamped, reset_distance: float) -> None:
        """Clear the local costmap within `reset_distance` metres of a place."""
        request = srv.ClearCostmapAroundPose.Request(
            pose=pose, reset_distance=float(reset_distance)
        )
        client = self.clear_local_costmap_around_pose_srv
        self._call(client, "Clear local costmap around pose", request)

    clearCostmapAroundPose = clearLocalCostmapAroundPose  # the name in ROS 2 Jazzy

    def clearGlobalCostmapAroundPose(self, pose: PoseStamped, reset_distance: float) -> None:
        """Clear the global costmap within `reset_distance` metres of a place."""
        request = srv.ClearCostmapAroundPose.Request(
            pose=pose, reset_distance=float(reset_distance)
        )
        client = self.clear_global_costmap_around_pose_srv
        self._call(client, "Clear global costmap around pose", request)

    def getGlobalCostmap(self) -> Costmap | None:
        """Return the global costmap, or None if the call failed."""
        request = srv.GetCostmap.Request()
        response = self._call(self.get_costmap_global_srv, "Get global costmap", request)
        return None if response is None else response.map

    def getLocalCostmap(self) -> Costmap | None:
        """Return the local costmap, or None if the call failed."""
        request = srv.GetCostmap.Request()
        response = self._call(self.get_costmap_local_srv, "Get local costmap", request)
        return None if response is None else response.map

    def toggleCollisionMonitor(self, enable: bool) -> None:
        """Switch the collision monitor on or off."""
        request = srv.Toggle.Request(enable=enable)
        self._call(self.toggle_collision_monitor_srv, "Toggle collision monitor", request)
