"""View of a domain: its displays, and the thread that draws them."""

from __future__ import annotations

import queue
import time
import traceback
from concurrent.futures import Future
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Any

from zbot.errors import ZbotError
from zbot.libraries.robot_description.file import read_description
from zbot.libraries.robot_description.urdf import read_urdf
from zbot.log import get_logger
from zbot.names import expand_topic_name
from zbot.tf2.rigid import Rigid
from zbot.view.arrangement.arrangement import Arrangement, PointerTopics
from zbot.view.arrangement.link import PARAMETER, link_text, read_link
from zbot.view.arrangement.rviz_writer import rviz_text
from zbot.view.budget import Budget
from zbot.view.camera import VIEWS, Camera
from zbot.view.display_list import DisplayList
from zbot.view.displays.tf import TF
from zbot.view.errors import DisplayError
from zbot.view.panel import Wish
from zbot.view.pose import yaw_only
from zbot.view.shape import Note, Picture
from zbot.view.tools.pointer import MOVE_CAMERA, Drawn, Pointer
from zbot.view.tools.tool import Surroundings

from geometry_msgs.msg import TransformStamped

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from pathlib import Path
    from threading import Event

    from zbot.libraries.robot_description.urdf import Joint
    from zbot.view.display_list import Listed
    from zbot.view.drawing import Drawing
    from zbot.view.frames import Frames
    from zbot.view.panel import Panel
    from zbot.view.shown import Shown
    from zbot.view.source import Clock, Source, Timeline
    from zbot.view.tools.tool import Outlet

#: Drawings a second.
RATE_HZ = 15.0
_SAY_PERIOD_S = 0.5
_TF_TOPIC = "/tf"
_TOOL = "tool"
_DARK = 128  #: a background is dark if its brightest channel is below this
_PAUSED = "Paused: the picture stands, and messages are dropped."


def own_name(topic: str) -> str:
    """Return the full name of a topic for a view without a node of its own."""
    return expand_topic_name(topic, "rviz2", "/")


class View:
    """The displays of a domain. Only `run` changes them, in its thread.

    Args:
        system: The domain, or a bag.
        frames: Its transforms.
        drawing: The scene.
        make_panel: Function that returns the panel. Its argument is called with each wish of the
            user.
        resolve: Function that returns the full name of a topic in an arrangement.
        clock: The clock.
        outlet: What sends the messages of the tools.
        timeline: The bag that is played, or None for a domain.
        address: The address of the view, for links.
        budget: What the displays may send.
    """

    def __init__(
        self,
        system: Source,
        frames: Frames,
        drawing: Drawing,
        make_panel: Callable[[Callable[[Wish, Any], None]], Panel],
        *,
        resolve: Callable[[str], str] = own_name,
        clock: Clock,
        outlet: Outlet,
        timeline: Timeline | None = None,
        address: str = "",
        budget: Budget | None = None,
    ) -> None:
        self._system, self._frames, self._drawing = system, frames, drawing
        self._clock, self._outlet, self._timeline = clock, outlet, timeline
        self._wishes: queue.SimpleQueue[Callable[[], None]] = queue.SimpleQueue()
        self._panel = make_panel(self._ask)
        self._list = DisplayList(system, self._panel, self._wishes.put, self._erase, resolve)
        self._arrangement = Arrangement()
        self._camera = Camera()
        self._resolve, self._address = resolve, address
        self._budget = budget or Budget(None)
        self._topics = _resolved(PointerTopics(), resolve)
        self._pointer = Pointer(self._surroundings, self._drawn, lambda: self._frames.tree.poses)
        self._is_paused = False
        self._said_s = 0.0
        if timeline is not None:
            self._panel.add_timeline(timeline.length_s)

    def open_link(self, text: str) -> None:
        """Open the arrangement of a link soon. Any thread may call this."""
        self._wishes.put(partial(self._open_link, text))

    def rviz_file(self) -> Future[str]:
        """Ask for the text of an `.rviz` file with the present arrangement. Any thread may ask."""
        asked: Future[str] = Future()

        def answer() -> None:
            if asked.set_running_or_notify_cancel():
                try:
                    asked.set_result(rviz_text(self._present()))
                except Exception as error:
                    asked.set_exception(error)
                    raise

        self._wishes.put(answer)
        return asked

    def _open_link(self, text: str) -> None:
        self.open(read_link(text))

    def open(self, arrangement: Arrangement) -> str:
        """Show the displays of an arrangement, or the usual ones if it has none.

        Call it before `run`, or in its thread.

        Returns:
            A sentence about what the view does not have, or an empty text.
        """
        self._arrangement = arrangement
        problems = self._list.arrange(arrangement.displays) if arrangement.displays else ()
        self._topics = _resolved(arrangement.topics, self._resolve)
        if arrangement.fixed_frame:
            self._frames.choose(arrangement.fixed_frame)
        if arrangement.background is not None:
            self._panel.set_dark(is_dark=max(arrangement.background) < _DARK)
            self._drawing.set_background(arrangement.background)
        if arrangement.camera is not None:
            self._camera = arrangement.camera
            self._drawing.look(self._camera)
        self._panel.choose(arrangement.fixed_frame, arrangement.camera)
        misfits = (*arrangement.misfits, *problems)
        sentence = replace(arrangement, misfits=misfits).misfit_sentence
        self._panel.note(sentence)
        return sentence

    def show_file(self, path: Path) -> None:
        """Show a file with a robot description, with all its joints at 0.

        Raises:
            DescriptionError: The file is not a robot description.
        """
        for joint in read_urdf(read_description(path)).joints.values():
            self._frames.add_fixed_link(_stamped(joint))
        self._list.show_file(path)

    def run(self, is_over: Event) -> None:
        """Draw until an event is set."""
        while not is_over.is_set():
            start_s = time.monotonic()
            try:
                self.tick()
            except Exception as error:  # noqa: BLE001 - the next drawing may succeed
                _report(error)
            # At least half of the time is for other threads, e.g. those of viser.
            used_s = time.monotonic() - start_s
            is_over.wait(max(1 / RATE_HZ - used_s, used_s))

    def tick(self) -> None:
        """Draw once."""
        while not self._wishes.empty():
            self._carry_out(self._wishes.get())
        self._look()
        shown = [(listed, listed.shown) for listed in self._list if listed.shown is not None]
        if self._is_paused:
            for _, one in shown:
                one.skip()
            self._panel.say(_PAUSED, is_warning=True)
            return
        for _, one in shown:
            self._frames.note(one.take())
        self._frames.refresh()
        now_ns = self._clock.now_ns()
        with self._drawing.atomic():
            self._follow()
            self._draw_tool()
            for listed, one in shown:
                self._draw_if_due(listed, one, now_ns)
        if time.monotonic() - self._said_s > _SAY_PERIOD_S:
            self._said_s = time.monotonic()
            self._say(shown)

    def _carry_out(self, wish: Callable[[], None]) -> None:
        try:
            wish()
        except ZbotError as error:
            self._panel.note(str(error))
        except Exception as error:  # noqa: BLE001 - the view goes on
            _report(error)
            self._panel.note(f"The view could not do this: {error!r}")

    def _look(self) -> None:
        """Look for new topics, and for what a jump of the time has changed."""
        if self._timeline is not None:
            self._timeline.advance()
        if self._list.refresh():
            self._clock.look(self._system.snapshot())
        if self._clock.has_jumped_back():
            self._list.restart()

    def _ask(self, wish: Wish, value: Any) -> None:
        """Put a wish of the user into the queue. Any thread may call this."""
        actions: dict[Wish, Callable[[Any], None]] = {
            Wish.FIXED_FRAME: self._frames.choose,
            Wish.TARGET: self._choose_target,
            Wish.TURN: self._choose_turning,
            Wish.VIEW: self._choose_view,
            Wish.PAUSE: self._pause,
            Wish.TOOL: self._choose_tool,
            Wish.CLICK: self._pointer.click,
            Wish.LINK: self._make_link,
            **self._timeline_actions(),
        }
        self._wishes.put(partial(actions[wish], value))

    def _timeline_actions(self) -> dict[Wish, Callable[[Any], None]]:
        timeline = self._timeline
        if timeline is None:
            return {}
        return {
            Wish.PLAY: timeline.play,
            Wish.SEEK: timeline.seek,
            Wish.SPEED: timeline.set_speed,
        }

    def _choose(self, shown: Shown, menu: str, entry: str) -> None:
        """Choose an entry of a display's menu soon. Any thread may call this."""
        self._wishes.put(partial(shown.display.choose, menu, entry))

    def _choose_target(self, name: str) -> None:
        if name != self._camera.target:
            self._camera = replace(self._camera, target=name)
            self._drawing.centre()

    def _choose_turning(self, turns: bool) -> None:
        self._camera = replace(self._camera, turns=turns)

    def _choose_view(self, name: str) -> None:
        self._drawing.look_from(*VIEWS[name])

    def _pause(self, is_paused: bool) -> None:
        self._is_paused = is_paused

    def _choose_tool(self, name: str) -> None:
        self._pointer.choose(name)
        is_used = name != MOVE_CAMERA
        self._drawing.listen(partial(self._ask, Wish.CLICK) if is_used else None)

    def _surroundings(self) -> Surroundings:
        return Surroundings(self._frames.fixed, self._clock.now_ns(), self._topics, self._outlet)

    def _drawn(self) -> Iterator[Drawn]:
        for listed in self._list:
            if listed.shown is None:
                continue
            for name, item in listed.shown.display.items.items():
                pose, _ = self._frames.pose(item.frame, item.stamp_ns)
                if pose is not None:
                    kind, message = listed.kind.name, listed.shown.message
                    press = partial(listed.shown.display.press, name)
                    at = pose @ item.pose
                    yield Drawn(kind, listed.topic, name, item, at, message, press)

    def _draw_tool(self) -> None:
        for name in set(self._drawing.names(_TOOL)) - set(self._pointer.items):
            self._drawing.erase(_TOOL, name)
        for name, item in self._pointer.items.items():
            self._drawing.draw(_TOOL, name, item)
            self._drawing.place(_TOOL, name, Rigid())
        self._panel.say_of_tool(self._pointer.sentence)

    def _present(self) -> Arrangement:
        """Return the arrangement as it is now."""
        camera = self._drawing.camera
        if camera is not None:
            camera = replace(camera, target=self._camera.target, turns=self._camera.turns)
        return replace(
            self._arrangement,
            displays=self._list.choices(),
            fixed_frame=self._frames.fixed,
            camera=camera or self._camera,
        )

    def _make_link(self, _: object) -> None:
        text = link_text(self._present())
        mark = "&" if "?" in self._address else "?"
        self._panel.show_link(f"{self._address}{mark}{PARAMETER}={text}")

    def _follow(self) -> None:
        pose, _ = self._frames.pose(self._camera.target, 0)
        if pose is None:
            return  # the picture stays where it is until the frame is there
        if self._camera.turns:
            self._drawing.follow(yaw_only(pose))
        else:
            self._drawing.follow(Rigid(pose.translation))

    def _erase(self, label: str) -> None:
        for name in self._drawing.names(label):
            self._drawing.erase(label, name)

    def _draw_if_due(self, listed: Listed, shown: Shown, now_ns: int) -> None:
        now_s = time.monotonic()
        if not self._budget.is_due(listed.label, now_s):
            return
        before = self._drawing.sent
        self._draw(listed, shown, now_ns)
        self._budget.spend(listed.label, self._drawing.sent - before, now_s)

    def _show_content(self, listed: Listed, shown: Shown) -> None:
        """Show pictures and lines of text beside the scene, if the budget allows it."""
        now_s = time.monotonic()
        content = _content(shown)
        if self._budget.is_due(listed.label, now_s) and listed.row.show(content):
            size = sum(len(one.data) * 4 / 3 for one in content if isinstance(one, Picture))
            self._budget.spend(listed.label, size, now_s)

    def _draw(self, listed: Listed, shown: Shown, now_ns: int) -> None:
        display = shown.display
        try:
            display.tick(now_ns)
        except DisplayError as error:
            shown.mistake = str(error)
        if isinstance(display, TF):
            display.follow(self._frames.tree)
        self._pass_on(shown)
        shown.lacking = None
        for name in self._drawing.names(listed.label):
            if name not in display.items:
                self._drawing.erase(listed.label, name)
        for name, item in display.items.items():
            try:
                drawn = shown.fitting(name, item, partial(self._budget.fitting, listed.label))
                self._drawing.draw(listed.label, name, drawn)
            except DisplayError as error:
                shown.mistake = str(error)
            except Exception as error:  # noqa: BLE001 - viser's; other displays must be drawn
                shown.mistake = f"it cannot be drawn: {type(error).__name__}: {error}"
            pose, is_right = shown.pose(name, item, self._frames)
            if not is_right:
                shown.lacking = shown.lacking or item
            self._drawing.place(listed.label, name, pose and pose @ item.pose)

    def _pass_on(self, shown: Shown) -> None:
        """Send the messages of a display, and make its calls."""
        display = shown.display
        outgoing, calls = [*display.outgoing], [*display.calls]
        display.outgoing.clear()
        display.calls.clear()
        for topic, type_name, message in outgoing:
            try:
                if message is None:
                    self._outlet.open(topic, type_name)
                else:
                    self._outlet.send(topic, type_name, message)
            except ZbotError as error:
                shown.mistake = "" if message is None else str(error)
        for call in calls:
            self._outlet.ask(*call, lambda answer: self._wishes.put(partial(shown.show, answer)))

    def _say(self, shown: list[tuple[Listed, Shown]]) -> None:
        """Show sentences, which need not be as new as the picture."""
        self._panel.offer_frames(self._frames.tree.names)
        self._budget.plan({listed.label: one.demand(RATE_HZ) for listed, one in shown})
        timeline = self._timeline
        if timeline is not None:
            self._panel.show_time(timeline.position_s, is_playing=timeline.is_playing)
        for listed, one in shown:
            lacking = one.lacking
            one.warning = (
                ""
                if lacking is None
                else self._frames.why(lacking.frame, lacking.stamp_ns, listed.topic)
            )
            sentence, is_warning = one.sentence()
            if listed.kind is TF:
                sentence, is_warning = self._tf_sentence(), not self._frames.tree.parents
            listed.row.say(sentence, is_warning=is_warning)
            listed.row.offer(one.display.menus, partial(self._choose, one))
            self._show_content(listed, one)
        fixed = self._frames.fixed
        self._panel.say(f"The fixed frame is {fixed}." if fixed else "There are no frames yet.")

    def _tf_sentence(self) -> str:
        tree = self._frames.tree
        if not tree.parents:
            return f"nobody publishes transforms on {_TF_TOPIC} or /tf_static"
        roots = tree.roots
        trees = f"{len(roots)} trees: {', '.join(sorted(roots))}" if len(roots) > 1 else "one tree"
        return f"{len(tree.names)} frames in {trees}"


def _report(error: Exception) -> None:
    get_logger("zbot.view").error("".join(traceback.format_exception(error)))


def _content(shown: Shown) -> list[Picture | Note]:
    """Return what a display shows beside the scene."""
    shapes = (shape for item in shown.display.items.values() for shape in item.shapes)
    return [shape for shape in shapes if isinstance(shape, (Picture, Note))]


def _resolved(topics: PointerTopics, resolve: Callable[[str], str]) -> PointerTopics:
    """Return the full names of the topics of the tools."""
    return replace(
        topics,
        initial_pose=resolve(topics.initial_pose),
        goal=resolve(topics.goal),
        point=resolve(topics.point),
    )


def _stamped(joint: Joint) -> Any:
    """Return the transform of a joint at 0."""
    message = TransformStamped(child_frame_id=joint.child)
    message.header.frame_id = joint.parent
    pose = joint.transform()
    place, rotation = message.transform.translation, message.transform.rotation
    place.x, place.y, place.z = pose.translation
    rotation.x, rotation.y, rotation.z, rotation.w = pose.rotation
    return message
