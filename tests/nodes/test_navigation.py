"""Tests of map_server, map_saver and lifecycle_manager."""

from __future__ import annotations

from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

import pytest

import zbot
from tests.conftest import wait_until
from zbot.libraries.navigation.map_file import read_map
from zbot.node.errors import ServiceError
from zbot.qos import DurabilityPolicy, QoSProfile
from zbot_nodes.navigation.lifecycle_manager import LifecycleManager
from zbot_nodes.navigation.map_saver_server import MapSaver
from zbot_nodes.navigation.map_server import MapServer
from zbot_nodes.startup.program import ParameterError

from lifecycle_msgs.srv import ChangeState
from nav2_msgs.srv import LoadMap, ManageLifecycleNodes, SaveMap
from nav_msgs.msg import OccupancyGrid
from nav_msgs.srv import GetMap
from std_msgs.msg import Bool
from std_srvs.srv import Trigger

if TYPE_CHECKING:
    from pathlib import Path

    from tests.conftest import Start
    from tests.nodes.conftest import Bench

KEPT = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
YAML = """image: lab.pgm
resolution: 0.5
origin: [0, 0, 0]
negate: 0
occupied_thresh: 0.65
free_thresh: 0.25
"""


@pytest.fixture
def lab(tmp_path: Path) -> str:
    (tmp_path / "lab.yaml").write_text(YAML)
    (tmp_path / "lab.pgm").write_bytes(b"P5 2 1 255 \0\xff")
    return str(tmp_path / "lab.yaml")


def change(bench: Bench, node: str, number: int) -> bool:
    request = ChangeState.Request()
    request.transition.id = number
    return bool(bench.call(ChangeState, f"/{node}/change_state", request).success)


def test_a_map_is_published_when_the_server_is_active(bench: Bench, lab: str) -> None:
    maps = bench.watch(OccupancyGrid, "/floor", KEPT)
    node = bench.run(MapServer, {"yaml_filename": lab, "topic_name": "floor", "frame_id": "f1"})
    assert change(bench, "map_server", 1)
    assert not bench.call(GetMap, "/map_server/map", GetMap.Request()).map.data
    refused = bench.call(LoadMap, "/map_server/load_map", LoadMap.Request(map_url=lab))
    assert refused.result == LoadMap.Response.RESULT_UNDEFINED_FAILURE
    assert maps == []
    assert change(bench, "map_server", 3)
    assert wait_until(lambda: len(maps) == 1)
    assert list(maps[0].data) == [100, 0]
    assert maps[0].header.frame_id == "f1"
    assert maps[0].info.map_load_time.sec > 0
    got = bench.call(GetMap, "/map_server/map", GetMap.Request()).map
    assert list(got.data) == [100, 0]
    assert change(bench, "map_server", 4)
    assert change(bench, "map_server", 2)
    assert node.get_parameter("topic_name").value == "floor"


def test_another_map_is_loaded_on_request(bench: Bench, lab: str, tmp_path: Path) -> None:
    maps = bench.watch(OccupancyGrid, "/map", KEPT)
    node = bench.run(MapServer)
    defaults = [
        node.get_parameter(name).value for name in ("yaml_filename", "topic_name", "frame_id")
    ]
    assert defaults == ["", "map", "map"]
    assert change(bench, "map_server", 1)
    assert change(bench, "map_server", 3)
    (tmp_path / "bad.yaml").write_text("image: 5")
    (tmp_path / "no_image.yaml").write_text(YAML.replace("lab.pgm", "none.pgm"))
    results = [
        bench.call(LoadMap, "/map_server/load_map", LoadMap.Request(map_url=str(tmp_path / name)))
        for name in ("none.yaml", "bad.yaml", "no_image.yaml", "lab.yaml")
    ]
    kinds = LoadMap.Response
    assert [result.result for result in results] == [
        kinds.RESULT_MAP_DOES_NOT_EXIST,
        kinds.RESULT_INVALID_MAP_METADATA,
        kinds.RESULT_INVALID_MAP_DATA,
        kinds.RESULT_SUCCESS,
    ]
    assert list(results[-1].map.data) == [100, 0]
    assert wait_until(lambda: len(maps) == 1)
    assert lab.endswith("lab.yaml")


def test_a_map_that_cannot_be_read_fails_the_configuration(bench: Bench) -> None:
    bench.run(MapServer, {"yaml_filename": "/none.yaml"})
    assert not change(bench, "map_server", 1)


def test_maps_are_saved_on_request(bench: Bench, tmp_path: Path) -> None:
    node = bench.run(MapSaver, {"save_map_timeout": 0.5, "use_sim_time": True})
    defaults = ("free_thresh_default", "occupied_thresh_default", "map_subscribe_transient_local")
    assert [node.get_parameter(default).value for default in defaults] == [0.25, 0.65, True]
    request = SaveMap.Request(map_topic="floor", map_url=str(tmp_path / "saved"))
    assert not bench.call(SaveMap, "/map_saver/save_map", request).result
    node.set_parameters([zbot.Parameter("save_map_timeout", value=20.0)])
    grid = OccupancyGrid(data=[0, 100])
    grid.info.width, grid.info.height, grid.info.resolution = 2, 1, 0.5
    bench.watcher.create_publisher(OccupancyGrid, "/floor", KEPT).publish(grid)
    assert bench.call(SaveMap, "/map_saver/save_map", request).result
    assert list(read_map(str(tmp_path / "saved.yaml")).data) == [0, 100]
    request.image_format = "gif"
    assert not bench.call(SaveMap, "/map_saver/save_map", request).result


# -- the manager ---------------------------------------------------------------------------------


def manage(bench: Bench, command: int) -> bool:
    service = "/lifecycle_manager/manage_nodes"
    request = ManageLifecycleNodes.Request(command=command)
    return bool(bench.call(ManageLifecycleNodes, service, request).success)


def is_active(bench: Bench) -> bool:
    found = bench.call(Trigger, "/lifecycle_manager/is_active", Trigger.Request())
    return bool(found.success)


def test_nodes_are_brought_up_in_their_order(bench: Bench, logged: list[Any]) -> None:
    bench.run(MapServer)
    bench.run(MapSaver)
    activated = bench.watch(Bool, "/lifecycle_manager/managed_nodes_activated", KEPT)
    node = bench.run(
        LifecycleManager, {"node_names": ["map_server", "map_saver"], "autostart": True}
    )
    assert wait_until(lambda: bool(activated) and activated[-1].data, 15)
    assert is_active(bench)
    steps = [record.message for record in logged if record.name == "lifecycle_manager"]
    assert [step for step in steps if step.startswith(("Conf", "Act"))] == [
        "Configuring map_server",
        "Configuring map_saver",
        "Activating map_server",
        "Activating map_saver",
    ]
    requests = ManageLifecycleNodes.Request
    for command, active, text in (
        (requests.PAUSE, False, "Managed nodes have been paused"),
        (requests.RESUME, True, "Managed nodes are active"),
        (requests.RESET, False, "Managed nodes have been reset"),
        (requests.CONFIGURE, False, "Managed nodes are now configured"),
        (requests.CLEANUP, False, "Managed nodes have been cleaned up"),
        (requests.STARTUP, True, "Managed nodes are active"),
        (requests.SHUTDOWN, False, "Managed nodes have been shut down"),
    ):
        assert manage(bench, command)
        assert is_active(bench) is active
        assert logged[-1].message == text
    for command, last, tried in (  # they are finalized
        (requests.STARTUP, "Failed to bring up all requested nodes. Aborting bringup.", 1),
        (requests.RESET, "Failed to reset nodes: aborting reset", 1),
        (requests.SHUTDOWN, "Failed to shut down all nodes", 6),
    ):
        logged.clear()
        assert not manage(bench, command)
        assert logged[-1].message == last
        failures = [
            record for record in logged if record.message.startswith("Failed to change state")
        ]
        assert len(failures) == tried
    defaults = {"service_timeout": 5.0, "bond_timeout": 4.0, "attempt_respawn_reconnection": True}
    assert {name: node.get_parameter(name).value for name in defaults} == defaults


def test_a_missing_node_is_named(bench: Bench, logged: list[Any]) -> None:
    bench.run(LifecycleManager, {"node_names": ["amcl"], "service_timeout": 0.2})
    assert not manage(bench, ManageLifecycleNodes.Request.STARTUP)
    text = "\n".join(record.message for record in logged)
    assert "amcl was not there in 0.2 s: is it a managed node?" in text
    assert "Failed to bring up all requested nodes. Aborting bringup." in text
    for parameters in ({}, {"node_names": "amcl"}, {"node_names": 1}):
        with pytest.raises(ParameterError, match="node_names must name at least one node"):
            bench.run(LifecycleManager, parameters)


def test_a_manager_works_while_the_time_of_a_simulation_stands_still(bench: Bench) -> None:
    bench.run(MapServer)
    activated = bench.watch(Bool, "/lifecycle_manager/managed_nodes_activated", KEPT)
    parameters = {"node_names": ["map_server"], "autostart": True, "use_sim_time": True}
    bench.run(LifecycleManager, parameters)
    assert wait_until(lambda: bool(activated) and activated[-1].data, 15)


def test_a_manager_forgets_a_request_without_an_answer(bench: Bench, logged: list[Any]) -> None:
    parameters = {"node_names": ["amcl"], "service_timeout": 0.2, "use_sim_time": True}
    manager: Any = bench.run(LifecycleManager, parameters)
    forgotten: list[zbot.Future[Any]] = []
    manager.changers["amcl"] = SimpleNamespace(
        service_is_ready=lambda: True,
        call_async=lambda _request: zbot.Future(),
        remove_pending_request=forgotten.append,
    )
    assert not manage(bench, ManageLifecycleNodes.Request.STARTUP)
    assert len(forgotten) == 1
    assert "Failed to change state for node: amcl" in [record.message for record in logged]


def test_a_node_whose_answer_is_an_error_is_named(bench: Bench, logged: list[Any]) -> None:
    manager: Any = bench.run(LifecycleManager, {"node_names": ["amcl"]})
    answer: zbot.Future[Any] = zbot.Future()
    answer.set_exception(ServiceError("/amcl/change_state", "server_gone", "the server ended"))
    manager.changers["amcl"] = SimpleNamespace(
        service_is_ready=lambda: True, call_async=lambda _request: answer
    )
    assert not manage(bench, ManageLifecycleNodes.Request.STARTUP)
    text = "\n".join(record.message for record in logged)
    assert "the server ended" in text
    assert "Failed to change state for node: amcl" in text


def test_the_others_go_down_with_a_node(bench: Bench, logged: list[Any]) -> None:
    bench.run(MapServer)
    saver = bench.run(MapSaver)
    bench.run(LifecycleManager, {"node_names": ["map_server", "map_saver"]})
    assert manage(bench, ManageLifecycleNodes.Request.STARTUP)
    saver.destroy_node()
    assert wait_until(
        lambda: any("SERVER map_saver IS DOWN" in record.message for record in logged), 15
    )
    assert wait_until(
        lambda: any("Cleaning up map_server" in record.message for record in logged), 15
    )
    assert not is_active(bench)


def test_the_programs_bring_up_and_save_a_map(start: Start, lab: str, tmp_path: Path) -> None:
    run = ("zbot", "run")
    server = start(
        *run, "nav2_map_server", "map_server", "--ros-args", "-p", f"yaml_filename:={lab}"
    )
    manager = start(
        *(*run, "nav2_lifecycle_manager", "lifecycle_manager", "--ros-args"),
        *("-p", "autostart:=true", "-p", "node_names:=[map_server]", "-r", "__node:=maps"),
    )
    manager.wait_for("Managed nodes are active", 20)
    server.wait_for("2 X 1 map @ 0.5 m/cell")
    patient = ("--ros-args", "-p", "save_map_timeout:=20.0")
    saver = start(*run, "nav2_map_server", "map_saver_cli", "-f", "copy", *patient)
    saver.wait_for("Map saved in copy.yaml")
    assert saver.wait() == 0
    assert list(read_map(str(tmp_path / "copy.yaml")).data) == [100, 0]
    missing = start(*run, "nav2_map_server", "map_saver_cli", "-t", "none")
    missing.wait_for("error: no map came on the topic none in 2 s")
    assert missing.wait() == 1
