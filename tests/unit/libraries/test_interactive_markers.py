from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest

import zbot
from zbot.libraries.interactive_markers import InteractiveMarkerServer, MenuHandler

from geometry_msgs.msg import Pose
from visualization_msgs.msg import InteractiveMarker, InteractiveMarkerFeedback
from visualization_msgs.srv import GetInteractiveMarkers

if TYPE_CHECKING:
    from tests.conftest import MakeContext

MOVED = InteractiveMarkerFeedback.POSE_UPDATE
SELECTED = InteractiveMarkerFeedback.MENU_SELECT


class Scene:
    """Server with the marker `box`, and what it has published."""

    def __init__(self, node: zbot.Node) -> None:
        self.server = InteractiveMarkerServer(node, "scene")
        self.sent: list[Any] = []
        self.server._publisher.publish = self.sent.append  # type: ignore[assignment,method-assign]
        self.calls: list[InteractiveMarkerFeedback] = []
        self.server.insert(InteractiveMarker(name="box"), feedback_callback=self.calls.append)
        self.server.applyChanges()

    def move(self, x: float, client: str = "rviz") -> None:
        feedback = InteractiveMarkerFeedback(marker_name="box", client_id=client, event_type=MOVED)
        feedback.pose = pose(x)
        self.server.processFeedback(feedback)


def pose(x: float) -> Pose:
    made = Pose()
    made.position.x = x
    return made


@pytest.fixture
def scene(make_context: MakeContext) -> Scene:
    return Scene(zbot.Node("scene", context=make_context()))


def shown(scene: Scene) -> dict[str, float]:
    response = GetInteractiveMarkers.Response()
    scene.server._on_request(GetInteractiveMarkers.Request(), response)
    return {marker.name: marker.pose.position.x for marker in response.markers}


def test_changes_are_published_when_they_are_applied(scene: Scene) -> None:
    assert [sent_marker.name for sent_marker in scene.sent[0].markers] == ["box"]
    assert scene.server.setPose("box", pose(2.0))
    marker = scene.server.get("box")
    assert marker is not None
    assert (marker.pose.position.x, shown(scene)) == (2.0, {"box": 0.0})
    scene.server.applyChanges()
    scene.server.applyChanges()
    assert [(len(update.markers), len(update.poses), update.seq_num) for update in scene.sent] == [
        (1, 0, 1),
        (0, 1, 2),
    ]
    assert shown(scene) == {"box": 2.0}


def test_markers_are_erased(scene: Scene) -> None:
    assert not scene.server.erase("ball")
    assert scene.server.erase("box")
    assert (scene.server.get("box"), scene.server.setPose("box", pose(1.0))) == (None, False)
    scene.server.applyChanges()
    assert (list(scene.sent[-1].erases), shown(scene)) == (["box"], {})
    scene.server.insert(InteractiveMarker(name="box"))
    scene.server.applyChanges()
    scene.server.shutdown()
    scene.server.shutdown()
    assert list(scene.sent[-1].erases) == ["box"]


def test_a_user_moves_a_marker(scene: Scene) -> None:
    scene.move(3.0)
    assert shown(scene) == {"box": 3.0}
    assert (len(scene.calls), len(scene.sent[-1].poses)) == (1, 1)


def test_two_users_take_turns(scene: Scene) -> None:
    scene.move(3.0)
    scene.move(4.0, client="other")
    assert (shown(scene), len(scene.calls)) == ({"box": 3.0}, 1)


def test_a_type_of_feedback_has_a_function_of_its_own(scene: Scene) -> None:
    moves: list[Any] = []
    assert scene.server.setCallback("box", moves.append, MOVED)
    scene.move(1.0)
    assert (len(moves), len(scene.calls)) == (1, 0)
    assert scene.server.setCallback("box", None, MOVED)
    scene.move(2.0)
    assert (len(moves), len(scene.calls)) == (1, 1)
    assert not scene.server.setCallback("ball", moves.append)


def test_a_menu_calls_the_function_of_its_entry(scene: Scene) -> None:
    menu, selected = MenuHandler(), list[Any]()
    tools = menu.insert("tools")
    light = menu.insert("light", parent=tools, callback=selected.append)
    hidden = menu.insert("hidden")
    assert light is not None
    assert hidden is not None
    assert menu.insert("lost", parent=99) is None
    assert menu.setCheckState(light, MenuHandler.CHECKED)
    assert menu.setVisible(hidden, False)
    assert menu.apply(scene.server, "box")
    scene.server.applyChanges()
    (marker,) = scene.sent[-1].markers
    assert [(entry.title, entry.id, entry.parent_id) for entry in marker.menu_entries] == [
        ("tools", 1, 0),
        ("[x] light", 2, 1),
    ]
    feedback = InteractiveMarkerFeedback(marker_name="box", event_type=SELECTED, menu_entry_id=2)
    scene.server.processFeedback(feedback)
    assert len(selected) == 1
    assert (menu.getTitle(light), menu.getCheckState(light)) == ("light", MenuHandler.CHECKED)
    assert menu.setCheckState(light, MenuHandler.UNCHECKED)
    assert menu.reApply(scene.server)
    scene.server.applyChanges()
    assert scene.sent[-1].markers[0].menu_entries[1].title == "[ ] light"
    assert not menu.apply(scene.server, "ball")
