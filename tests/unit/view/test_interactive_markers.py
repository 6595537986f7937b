"""Interactive markers follow their server and the user, and the server gets what ROS 2 defines."""

from __future__ import annotations

import math
from typing import Any

import pytest

import zbot  # noqa: F401 - makes the messages importable
from tests.unit.view.messages import framed, marker
from zbot.tf2.rigid import Rigid
from zbot.view.displays import interactive_markers
from zbot.view.displays.interactive_markers import InteractiveMarkers
from zbot.view.errors import DisplayError
from zbot.view.shape import Gizmo

from geometry_msgs.msg import Quaternion
from visualization_msgs.msg import (
    InteractiveMarker,
    InteractiveMarkerControl,
    InteractiveMarkerFeedback,
    InteractiveMarkerPose,
    InteractiveMarkerUpdate,
    MenuEntry,
)
from visualization_msgs.srv import GetInteractiveMarkers

HALF = math.sqrt(0.5)
UP = Quaternion(y=-HALF, w=HALF)  # its x is the z of the marker


def control(mode: str, name: str = "c", **fields: Any) -> Any:
    number = getattr(InteractiveMarkerControl, mode)
    return InteractiveMarkerControl(name=name, interaction_mode=number, **fields)


def box(**fields: Any) -> Any:
    shape = marker(1)
    shape.header.frame_id = ""
    return control("BUTTON", "button", markers=[shape], always_visible=True, **fields)


def interactive(*controls: Any, name: str = "m", x: float = 1.0, **fields: Any) -> Any:
    made = framed(InteractiveMarker(name=name, scale=1.0, controls=[*controls], **fields))
    made.pose.position.x = x
    made.pose.orientation.w = 1.0
    return made


def shown(*markers: Any) -> InteractiveMarkers:
    display = InteractiveMarkers("/tools/update")
    display.take(GetInteractiveMarkers.Response(sequence_number=5, markers=[*markers]))
    display.tick(0)
    return display


def gizmo(display: InteractiveMarkers, number: int = 0, name: str = "m") -> Gizmo:
    (found,) = display.items[f"{name}/{number}/handle"].shapes
    assert isinstance(found, Gizmo)
    return found


def sent(display: InteractiveMarkers) -> list[Any]:
    messages = [one.message for one in display.outgoing if one.message is not None]
    assert {one.topic for one in display.outgoing} <= {"/tools/feedback"}
    display.outgoing.clear()
    return messages


def test_a_new_display_asks_for_all_markers() -> None:
    display = InteractiveMarkers("/tools/update")
    display.tick(0)
    display.tick(0)
    (call,) = display.calls
    assert call.service == "/tools/get_interactive_markers"
    assert not shown(interactive(box())).calls


def test_a_marker_is_drawn_at_its_pose_with_its_name() -> None:
    display = shown(interactive(box(), description="the box"))
    assert display.items["m/0/0"].pose.translation == (1, 0, 0)
    assert display.items["m/0/name"].pose.translation == (1, 0, 0.6)


def test_updates_move_change_and_erase_markers() -> None:
    display = shown(interactive(box()), interactive(box(), name="other"))
    moved = framed(InteractiveMarkerPose(name="m"))
    moved.pose.position.y, moved.pose.orientation.w = 3.0, 1.0
    update = InteractiveMarkerUpdate(type=1, seq_num=6, poses=[moved], erases=["other"])
    shapes = display.items["m/0/0"].shapes
    display.take(update)
    assert display.items["m/0/0"].pose.translation == (0, 3, 0)
    assert display.items["m/0/0"].shapes is shapes  # only its pose is sent
    assert [name for name in display.items if name.startswith("other")] == []


def test_a_marker_that_an_update_moves_often_is_drawn_once(monkeypatch: pytest.MonkeyPatch) -> None:
    display = shown(interactive(box()))
    drawn: list[str] = []
    monkeypatch.setattr(display, "_show", lambda marker: drawn.append(marker.name))
    poses = [framed(InteractiveMarkerPose(name="m")) for _ in range(50)]
    poses[-1].pose.position.y = 3.0
    display.take(InteractiveMarkerUpdate(type=1, seq_num=6, poses=poses))
    assert drawn == ["m"]
    assert display._markers["m"].pose.position.y == 3.0


def test_after_a_missed_update_the_display_asks_again() -> None:
    display = shown(interactive(box()))
    display.take(InteractiveMarkerUpdate(type=0, seq_num=5))
    display.tick(0)
    assert not display.calls
    display.take(InteractiveMarkerUpdate(type=1, seq_num=8))
    display.tick(0)
    assert len(display.calls) == 1


def test_after_another_start_of_its_server_the_display_asks_again() -> None:
    display = shown(interactive(box()))
    display.take(InteractiveMarkerUpdate(type=1, seq_num=1))
    display.tick(0)
    assert len(display.calls) == 1


def test_a_marker_is_forgotten_without_those_whose_names_begin_alike() -> None:
    display = shown(interactive(box(), name="arm"), interactive(box(), name="arm/goal"))
    display.take(InteractiveMarkerUpdate(type=1, seq_num=6, erases=["arm"]))
    assert list(display.items) == ["arm/goal/0/0"]


@pytest.mark.parametrize(
    ("mode", "axes", "parts"),
    [
        ("MOVE_AXIS", (True, False, False), (True, False, False)),
        ("MOVE_PLANE", (False, True, True), (False, True, False)),
        ("ROTATE_AXIS", (False, True, True), (False, False, True)),
        ("MOVE_ROTATE", (False, True, True), (False, True, True)),
        ("MOVE_ROTATE_3D", (True, True, True), (True, True, True)),
    ],
)
def test_each_mode_has_its_handles(mode: str, axes: Any, parts: Any) -> None:
    found = gizmo(shown(interactive(control(mode))))
    assert found.axes == axes
    assert (found.has_arrows, found.has_squares, found.has_rings) == parts


def test_the_axis_of_a_control_is_its_x() -> None:
    display = shown(interactive(control("MOVE_AXIS", orientation=UP)))
    axis = display.items["m/0/handle"].pose.apply((1.0, 0.0, 0.0))
    assert axis == pytest.approx((1, 0, 1))  # above the marker, which is at x = 1


def test_a_drag_moves_the_marker_and_tells_the_server() -> None:
    display = shown(interactive(box(), control("MOVE_AXIS", "up", orientation=UP)))
    handle = gizmo(display, 1)
    handle.moved("start", Rigid())
    handle.moved("update", Rigid((0.2, 0.0, 0.0)))
    handle.moved("update", Rigid((0.5, 0.0, 0.0)))
    display.tick(0)
    (down,) = sent(display)  # servers keep one message, so there is one for each drawing
    display.tick(0)
    (moved,) = sent(display)
    assert (down.event_type, down.control_name) == (InteractiveMarkerFeedback.MOUSE_DOWN, "up")
    assert moved.event_type == InteractiveMarkerFeedback.POSE_UPDATE
    place = moved.pose.position
    assert (place.x, place.y, place.z) == pytest.approx((1, 0, 0.5))
    assert moved.client_id == down.client_id != ""
    assert display.items["m/0/0"].pose.translation == pytest.approx((1, 0, 0.5))
    assert display.items["m/1/handle"].pose.translation == (1, 0, 0)  # the browser moves it
    handle.moved("end", Rigid((0.5, 0.0, 0.0)))
    display.tick(0)
    (up,) = sent(display)
    assert up.event_type == InteractiveMarkerFeedback.MOUSE_UP
    assert display.items["m/1/handle"].pose.translation == pytest.approx((1, 0, 0.5))
    assert gizmo(display, 1) is not handle


def test_a_turn_is_around_the_axis_of_the_control() -> None:
    display = shown(interactive(control("ROTATE_AXIS", orientation=UP)))
    quarter = Rigid(rotation=(HALF, 0.0, 0.0, HALF))  # around the x of the control
    gizmo(display).moved("update", quarter)
    display.tick(0)
    turn = sent(display)[0].pose.orientation
    assert (turn.x, turn.y, turn.z, turn.w) == pytest.approx((0, 0, HALF, HALF))


def test_a_click_on_a_button_is_sent_with_its_place() -> None:
    display = shown(interactive(box()))
    assert display.press("m/0/0", (1.0, 0.1, 0.2)) == "m was clicked."
    (click,) = sent(display)
    assert click.event_type == InteractiveMarkerFeedback.BUTTON_CLICK
    assert (click.control_name, click.mouse_point.y, click.mouse_point_valid) == (
        "button",
        0.1,
        True,
    )
    assert display.press("gone/0/0", (0.0, 0.0, 0.0)) == ""


def test_an_entry_of_a_menu_is_sent_by_its_number() -> None:
    entries = [
        MenuEntry(id=1, title="Size"),
        MenuEntry(id=2, parent_id=1, title="Large"),
        MenuEntry(id=3, title="Delete"),
    ]
    display = shown(interactive(control("MENU", "menu"), menu_entries=entries))
    assert display.menus == {"m": ("Size / Large", "Delete")}
    display.choose("m", "Size / Large")
    (chosen,) = sent(display)
    assert chosen.event_type == InteractiveMarkerFeedback.MENU_SELECT
    assert (chosen.menu_entry_id, chosen.control_name) == (2, "menu")
    display.choose("m", "Gone")
    assert not sent(display)


def test_only_the_menus_of_new_markers_are_made(monkeypatch: pytest.MonkeyPatch) -> None:
    made: list[str] = []

    def title(entry: Any, _titles: Any) -> str:
        made.append(entry.title)
        return str(entry.title)

    monkeypatch.setattr(interactive_markers, "_title", title)
    display = shown(
        *(
            interactive(name=name, menu_entries=[MenuEntry(id=1, title=name)])
            for name in ("a", "b", "c")
        )
    )
    assert made == ["a", "b", "c"]
    update = InteractiveMarkerUpdate(type=InteractiveMarkerUpdate.UPDATE, seq_num=6, erases=["b"])
    update.markers = [interactive(name="d", menu_entries=[MenuEntry(id=1, title="d")])]
    display.take(update)
    assert made == ["a", "b", "c", "d"]
    assert display.menus == {"a": ("a",), "c": ("c",), "d": ("d",)}


def test_a_marker_without_a_frame_says_so() -> None:
    wrong = interactive(box(), name="wrong")
    wrong.header.frame_id = ""
    with pytest.raises(DisplayError, match="wrong: it names no frame"):
        shown(wrong, interactive(box()))
