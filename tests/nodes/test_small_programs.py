"""Tests of view_frames, tf2_monitor, republish and the aggregator of diagnostics."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any

import pytest

from tests.conftest import wait_until
from zbot.tf2 import Buffer, StaticTransformBroadcaster, TransformBroadcaster
from zbot_nodes.diagnostics.aggregator_node import Aggregator
from zbot_nodes.diagnostics.analyzer import ERROR, OK, WARN
from zbot_nodes.frames.tf2_monitor import TF2Monitor, frames_between
from zbot_nodes.images.image_codec import ImageCodecError, compress, decompress
from zbot_nodes.images.republish import Republish
from zbot_nodes.startup.program import ParameterError

from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
from geometry_msgs.msg import TransformStamped
from sensor_msgs.msg import CompressedImage, Image

if TYPE_CHECKING:
    from pathlib import Path

    from tests.conftest import Start
    from tests.nodes.conftest import Bench


def frame(bench: Bench, parent: str, child: str) -> TransformStamped:
    message = TransformStamped(child_frame_id=child)
    message.header.frame_id = parent
    message.header.stamp = bench.stamp()
    message.transform.rotation.w = 1.0
    return message


# -- frames --------------------------------------------------------------------------------------


def test_the_monitor_measures_delays(bench: Bench) -> None:
    node = TF2Monitor(context=bench.context)
    chain = TF2Monitor(("map", "tool"), context=bench.context)
    executors = [bench._spin(program).executor for program in (node, chain)]
    fixed, moving = StaticTransformBroadcaster(bench.watcher), TransformBroadcaster(bench.watcher)
    fixed.sendTransform([frame(bench, "map", "odom"), frame(bench, "base", "tool")])

    def is_measured() -> bool:
        moving.sendTransform(frame(bench, "odom", "base"))
        return len(node.delays["base"]) > 2 and bool(chain.net_delays)

    assert wait_until(is_measured, 10)
    # The nodes still measure, so their own threads make the reports.
    tasks = [
        executor.create_task(program.report)
        for executor, program in zip(executors, (node, chain), strict=True)
    ]
    assert wait_until(lambda: all(task.done() for task in tasks))
    report = tasks[0].result() or ""
    assert "RESULTS: for all Frames" in report
    assert re.search(r"Frame: base, published by <no authority available>, Average Delay: ", report)
    assert re.search(r"Node: <no authority available> [\d.e+]+ Hz, Average Delay: ", report)
    report = tasks[1].result() or ""
    assert "RESULTS: for map to tool" in report
    assert "Chain is: map -> odom -> base -> tool" in report
    assert "Net delay     avg = " in report


def test_the_way_between_frames_goes_over_their_common_parent() -> None:
    buffer = Buffer()
    for pair in ("map odom", "odom base", "base left", "base right", "x y"):
        parent, child = pair.split()
        message = TransformStamped(child_frame_id=child)
        message.header.frame_id = parent
        message.transform.rotation.w = 1.0
        buffer.set_transform_static(message)
    assert frames_between(buffer, "left", "right") == ["left", "base", "right"]
    assert frames_between(buffer, "right", "map") == ["right", "base", "odom", "map"]
    assert frames_between(buffer, "map", "y") == []


def test_the_programs_about_frames_run(start: Start, tmp_path: Path) -> None:
    words = ("--frame-id", "map", "--child-frame-id", "base")
    start("zbot", "run", "tf2_ros", "static_transform_publisher", *words).wait_for("from 'map'")
    view = start("zbot", "run", "tf2_tools", "view_frames", "-t", "3.0", "-o", "tree")
    view.wait_for("Exporting graph of 1 frames in tree.")
    assert view.wait() == 0
    assert '"map" -> "base"' in (tmp_path / "tree.gv").read_text()
    assert (tmp_path / "tree.svg").exists() or (tmp_path / "tree.pdf").exists()
    failing = start("zbot", "run", "tf2_tools", "view_frames", "-t", "0.1", "-o", "none/tree")
    failing.wait_for("error: cannot write 'none/tree.gv': No such file")
    assert failing.wait() == 1
    start("zbot", "run", "tf2_ros", "tf2_monitor").wait_for("Gathering data on all frames")
    wrong = start("zbot", "run", "tf2_ros", "tf2_monitor", "map")
    wrong.wait_for("usage: tf2_monitor framea frameb")
    assert wrong.wait() == 1


# -- images --------------------------------------------------------------------------------------


def picture(encoding: str = "rgb8") -> Image:
    data = bytes(range(48)) if encoding.endswith("8") and "mono" not in encoding else bytes(16)
    pixel = {"rgb8": 3, "bgr8": 3, "mono8": 1}.get(encoding, 3)
    return Image(height=4, width=4, encoding=encoding, step=4 * pixel, data=data)


@pytest.mark.parametrize("encoding", ["rgb8", "bgr8", "mono8"])
def test_png_keeps_every_pixel(encoding: str) -> None:
    pytest.importorskip("PIL.Image")
    image = picture(encoding)
    image.header.frame_id = "camera"
    message = compress(image, "png")
    last = "mono8" if encoding == "mono8" else "bgr8"
    assert message.format == f"{encoding}; png compressed {last}"
    again = decompress(message)
    assert (again.encoding, again.step, bytes(again.data)) == (
        encoding,
        image.step,
        bytes(image.data),
    )
    assert again.header.frame_id == "camera"


@pytest.mark.parametrize(
    ("make", "reason"),
    [
        (lambda: compress(picture("yuv422")), "the encoding 'yuv422' is none of rgb8"),
        (lambda: compress(Image(height=4, width=4, encoding="rgb8")), "has 0 bytes"),
        (lambda: decompress(CompressedImage(data=b"no image")), "no image that can be read"),
    ],
)
def test_images_that_cannot_be_converted_are_refused(make: Any, reason: str) -> None:
    pytest.importorskip("PIL.Image")
    with pytest.raises(ImageCodecError, match=reason):
        make()


def test_raw_images_are_compressed_for_listeners(bench: Bench) -> None:
    pytest.importorskip("PIL.Image")
    raw, packed = bench.watch(Image, "/out"), bench.watch(CompressedImage, "/out/compressed")
    node = bench.run(Republish)
    defaults = [node.get_parameter(name).value for name in ("in_transport", "out_transport")]
    assert defaults == ["raw", ""]
    bench.publisher(Image, "/in").publish(picture())
    assert wait_until(lambda: bool(raw) and bool(packed))
    assert packed[0].format == "rgb8; jpeg compressed bgr8"
    assert bytes(packed[0].data).startswith(b"\xff\xd8")


def test_compressed_images_are_unpacked(bench: Bench, logged: list[Any]) -> None:
    pytest.importorskip("PIL.Image")
    heard = bench.watch(Image, "/out")
    bench.run(Republish, {"in_transport": "compressed", "out_transport": "raw"})
    publisher = bench.publisher(CompressedImage, "/in/compressed")
    publisher.publish(CompressedImage(data=b"no image"))
    publisher.publish(compress(picture(), "png"))
    assert wait_until(lambda: len(heard) == 1)
    assert bytes(heard[0].data) == bytes(range(48))
    assert any("no image that can be read" in record.message for record in logged)
    assert bench.watcher.count_publishers("/out/compressed") == 0
    with pytest.raises(ParameterError, match="must be raw or compressed, not 'theora'"):
        bench.run(Republish, {"in_transport": "theora"})


def test_the_transports_are_words_of_the_command_line(start: Start) -> None:
    program = start("zbot", "run", "image_transport", "republish", "compressed", "raw")
    program.wait_for("The 'out_transport' parameter is set to: raw")


# -- diagnostics ---------------------------------------------------------------------------------

ANALYZERS = {
    "path": "Robot",
    "pub_rate": 20.0,
    "motors.type": "diagnostic_aggregator/GenericAnalyzer",
    "motors.path": "Motors",
    "motors.startswith": ["motor"],
}


def test_diagnostics_are_grouped(bench: Bench, logged: list[Any]) -> None:
    reports = bench.watch(DiagnosticArray, "/diagnostics_agg")
    states = bench.watch(DiagnosticStatus, "/diagnostics_toplevel_state")
    bench.run(Aggregator, ANALYZERS)
    publisher = bench.publisher(DiagnosticArray, "/diagnostics")
    statuses = [
        DiagnosticStatus(name="motor 1", level=WARN),
        DiagnosticStatus(name="camera", level=OK),
    ]
    publisher.publish(DiagnosticArray(status=statuses))

    def found() -> dict[str, bytes]:
        return {status.name: status.level for status in reports[-1].status} if reports else {}

    assert wait_until(lambda: "/Robot/Other/camera" in found())
    assert found() == {
        "/Robot/Motors": WARN,
        "/Robot/Motors/motor 1": WARN,
        "/Robot": WARN,
        "/Robot/Other": OK,
        "/Robot/Other/camera": OK,
    }
    assert wait_until(lambda: bool(states) and states[-1].level == WARN)
    assert any("No timestamp set for diagnostic message" in record.message for record in logged)


def test_a_critical_error_is_reported_at_once(bench: Bench) -> None:
    states = bench.watch(DiagnosticStatus, "/diagnostics_toplevel_state")
    bench.run(Aggregator, {**ANALYZERS, "critical": True, "pub_rate": 0.01})
    publisher = bench.publisher(DiagnosticArray, "/diagnostics")
    publisher.publish(DiagnosticArray(status=[DiagnosticStatus(name="motor", level=ERROR)]))
    assert wait_until(lambda: [state.name for state in states] == ["toplevel_state_critical"])
    assert states[0].level == ERROR


def test_the_aggregator_has_the_defaults_of_the_genuine_node(bench: Bench) -> None:
    node = bench.run(Aggregator)
    expected = {
        "path": "",
        "pub_rate": 1.0,
        "other_as_errors": False,
        "history_depth": 1000,
        "critical": False,
    }
    assert {name: node.get_parameter(name).value for name in expected} == expected
    with pytest.raises(ParameterError, match="pub_rate must be above 0"):
        bench.run(Aggregator, {"pub_rate": 0.0})


def test_the_aggregator_reads_a_file(start: Start, tmp_path: Path) -> None:
    (tmp_path / "a.yaml").write_text(
        "analyzers:\n  ros__parameters:\n    path: Robot\n    arms:\n      type: x/Unknown\n"
    )
    words = ("zbot", "run", "diagnostic_aggregator", "aggregator_node", "--ros-args")
    program = start(*words, "--params-file", "a.yaml")
    program.wait_for("error: the analyzer 'arms' has the type 'x/Unknown'")
    assert program.wait() == 1


def test_the_aggregator_notes_few_names_without_a_time(
    bench: Bench, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("zbot_nodes.diagnostics.aggregator_node._MOST_WARNINGS", 3)
    node: Any = bench.run(Aggregator)
    for number in range(5):
        node.accept(DiagnosticArray(status=[DiagnosticStatus(name=f"motor {number}")]))
    assert node.unstamped == {"motor 0", "motor 1", "motor 2"}
