"""Tree of frames with their history, and lookups of transforms between two frames."""

from __future__ import annotations

import threading
from operator import attrgetter
from typing import TYPE_CHECKING, Any

from zbot.errors import ArgumentTypeError, WrongTypeError, described
from zbot.errors.suggestion import did_you_mean
from zbot.executor.errors import WrongObjectError
from zbot.log import get_logger
from zbot.node.argument_check import is_node
from zbot.tf2.errors import (
    ConnectivityException,
    ExtrapolationException,
    InvalidArgumentException,
    LookupException,
    TransformException,
    kind_of,
)
from zbot.tf2.frame import Frame, Sample
from zbot.tf2.rigid import Quaternion, Rigid, Vector, normalized
from zbot.tf2.transform_check import transform_problem
from zbot.time import ClockType, Duration, Time

from geometry_msgs.msg import TransformStamped

if TYPE_CHECKING:
    from collections.abc import Container

_CACHE_S = 10.0
_MOST_FRAMES = 10_000  # a program may give each transform another name
_MOST_REFUSED = 100


class BufferCore:
    """Tree of frames with their history. All methods may be called from any thread.

    Args:
        cache_time: Time for which samples are kept. The default is 10 s.

    Raises:
        WrongTypeError: `cache_time` is not a `Duration`.
    """

    def __init__(self, cache_time: Duration | None = None) -> None:
        cache = Duration(seconds=_CACHE_S) if cache_time is None else cache_time
        if not isinstance(cache, Duration):
            raise _cache_time_error(cache)
        self._cache_ns = cache.nanoseconds
        self._frames: dict[str, Frame] = {}
        self._changed = threading.Condition()
        self._refused: set[str] = set()

    def set_transform(self, transform: Any, authority: str = "default_authority") -> None:
        """Add a `TransformStamped`. An invalid or too old transform is ignored and logged once.

        Raises:
            WrongObjectError: `transform` is not a `TransformStamped`.
        """
        self._set(transform, authority, is_static=False)

    def set_transform_static(self, transform: Any, authority: str = "default_authority") -> None:
        """Add a static `TransformStamped`."""
        self._set(transform, authority, is_static=True)

    def _set(self, transform: Any, authority: str, *, is_static: bool) -> None:
        if isinstance(transform, type) or not hasattr(transform, "child_frame_id"):
            raise WrongObjectError(
                f"set_transform needs one TransformStamped, not {kind_of(transform)}"
            )
        parent = transform.header.frame_id.removeprefix("/")
        child = transform.child_frame_id.removeprefix("/")
        if problem := transform_problem(transform):
            self._log_once(f"a transform from {authority} is ignored: {problem}")
            return
        stamp = Time.from_msg(transform.header.stamp).nanoseconds
        sample = Sample(stamp, parent, _rigid(transform.transform))
        with self._changed:
            frame = self._frames.get(child)
            if frame is None and self._has_room():
                frame = self._frames[child] = Frame(child, self._cache_ns)
            is_kept = frame is not None and frame.add(sample, is_static=is_static)
            if frame is not None:
                frame.authority = authority
                self._changed.notify_all()
        if frame is None:
            self._log_once(
                f"new frames from {authority} are ignored: there are {_MOST_FRAMES} frames already"
            )
        elif not is_kept and stamp < frame.oldest_ns:
            self._log_once(
                f"old transforms of the frame {child!r} from {authority} are ignored: their time "
                "is before the oldest time in the buffer"
            )

    def _has_room(self) -> bool:
        """Return whether a new frame can be kept. If necessary, drop half of the moving frames.

        They are those with the oldest samples. Static frames stay, as they are published only once.
        """
        if len(self._frames) < _MOST_FRAMES:
            return True
        moving = [frame for frame in self._frames.values() if not frame.is_static]
        if len(moving) < _MOST_FRAMES // 2:
            return False
        moving.sort(key=attrgetter("latest_ns"))
        for frame in moving[: (len(moving) + 1) // 2]:
            del self._frames[frame.name]
        return True

    def _log_once(self, text: str) -> None:
        if text not in self._refused and len(self._refused) < _MOST_REFUSED:
            self._refused.add(text)
            get_logger("tf2").error(text)

    def clear(self) -> None:
        """Remove all transforms except static ones, which are published only once."""
        with self._changed:
            self._frames = {name: frame for name, frame in self._frames.items() if frame.is_static}

    def lookup_transform_core(self, target_frame: str, source_frame: str, time: Any) -> Any:
        """Return the transform of `source_frame` in `target_frame`, as `TransformStamped`.

        Args:
            target_frame: The frame of the coordinates.
            source_frame: The frame whose position and orientation are returned.
            time: The time of the transform. Zero means the latest time with a known transform.

        Raises:
            InvalidArgumentException: A name is empty or begins with a slash.
            LookupException: A frame does not exist, or the frames form a loop.
            ConnectivityException: Nothing connects the frames.
            ExtrapolationException: The time is outside of the known samples.
        """
        with self._changed:
            pose, stamp_ns = self._find(target_frame, source_frame, _nanoseconds(time))
        return _stamped(pose, stamp_ns, target_frame, source_frame)

    def lookup_transform_full_core(
        self,
        target_frame: str,
        target_time: Any,
        source_frame: str,
        source_time: Any,
        fixed_frame: str,
    ) -> Any:
        """Return the transform of `source_frame` in `target_frame`, with a time for each frame.

        The result is the pose of `source_frame` at `source_time`, relative to `target_frame` at
        `target_time`. `fixed_frame` must not move between the two times. The errors are those of
        `lookup_transform_core`.
        """
        with self._changed:
            source, _ = self._find(fixed_frame, source_frame, _nanoseconds(source_time))
            target, stamp_ns = self._find(target_frame, fixed_frame, _nanoseconds(target_time))
        return _stamped(target @ source, stamp_ns, target_frame, source_frame)

    def can_transform_core(
        self, target_frame: str, source_frame: str, time: Any
    ) -> tuple[bool, str]:
        """Return whether a lookup would succeed, and the reason if it would not."""
        try:
            with self._changed:
                self._find(target_frame, source_frame, _nanoseconds(time))
        except (
            ConnectivityException,
            ExtrapolationException,
            InvalidArgumentException,
            LookupException,
        ) as error:
            return False, str(error)
        return True, ""

    def can_transform_full_core(
        self,
        target_frame: str,
        target_time: Any,
        source_frame: str,
        source_time: Any,
        fixed_frame: str,
    ) -> tuple[bool, str]:
        """Return whether `lookup_transform_full_core` would succeed, and the reason if not."""
        with self._changed:
            answer = self.can_transform_core(fixed_frame, source_frame, source_time)
            if answer[0]:
                answer = self.can_transform_core(target_frame, fixed_frame, target_time)
        return answer

    def _is_possible(self, target: str, source: str, time: Any) -> bool:
        """Return whether a lookup would succeed. To save time, give no reason."""
        with self._changed:
            for argument, name in (("target_frame", target), ("source_frame", source)):
                _check_type(argument, name)
            if not (self._exists(target) and self._exists(source)):
                return False
            try:
                self._find(target, source, _nanoseconds(time))
            except (ConnectivityException, ExtrapolationException, LookupException):
                return False
        return True

    def get_latest_common_time(self, target_frame: str, source_frame: str) -> Time:
        """Return the latest time at which the transform is known, or 0 if it is static.

        Raises:
            InvalidArgumentException: A name is empty or begins with a slash.
            LookupException: A frame does not exist, or the frames form a loop.
            ConnectivityException: Nothing connects the frames.
        """
        with self._changed:
            self._check("target_frame", target_frame)
            self._check("source_frame", source_frame)
            latest_ns = self._latest_common_ns(target_frame, source_frame)
        return Time(nanoseconds=latest_ns, clock_type=ClockType.ROS_TIME)

    def _find(self, target: str, source: str, stamp_ns: int) -> tuple[Rigid, int]:
        for argument, name in (("target_frame", target), ("source_frame", source)):
            self._check(argument, name)
        stamp_ns = stamp_ns or self._latest_common_ns(target, source)
        if target == source:
            return Rigid(), stamp_ns
        up, up_fault = self._to_ancestors(source, stamp_ns, {target})
        down, down_fault = self._to_ancestors(target, stamp_ns, up)
        name = next(reversed(down))
        if name in up:  # the nearest common ancestor
            return down[name].inverse() @ up[name], stamp_ns
        between = {name for names in self._path(target, source) for name in names}
        for ways, problem in ((up, up_fault), (down, down_fault)):
            # Errors above the nearest common ancestor are ignored: no frame there is needed.
            if problem is not None and next(reversed(ways)) in between:
                route = f"when looking up transform from frame [{source}] to frame [{target}]"
                raise ExtrapolationException(f"{problem}, {route}")
        raise self._unconnected(target, source)

    def _to_ancestors(
        self, name: str, stamp_ns: int, ends: Container[str]
    ) -> tuple[dict[str, Rigid], ExtrapolationException | None]:
        """Return the transform from a frame to itself and to each of its ancestors.

        The search ends at a frame in `ends`, or at the root of the tree. It also ends at a frame
        whose transform is unknown at that time. The second result is then the error.
        """
        pose = Rigid()
        poses = {name: pose}
        while name not in ends and (frame := self._frames.get(name)) is not None:
            try:
                sample = frame.at(stamp_ns)  # contains the parent, which may change over time
            except ExtrapolationException as error:
                return poses, error
            if sample.parent in poses:
                break
            name, pose = sample.parent, sample.pose @ pose
            poses[name] = pose
        return poses, None

    def _latest_common_ns(self, target: str, source: str) -> int:
        """Return the latest time at which the transform is known, or 0 if it is static."""
        if target == source:
            links = [source] if source in self._frames else []
        else:
            up, down = self._path(target, source)
            links = [*up, *down]
        frames = [self._frames[name] for name in links]
        return min((frame.latest_ns for frame in frames if not frame.is_static), default=0)

    def _check(self, argument: str, name: str) -> None:
        _check_type(argument, name)
        if not name or name.startswith("/"):
            problem = f"cannot start with a '/' like: {name}" if name else "cannot be empty"
            raise InvalidArgumentException(
                f"Invalid argument passed to lookupTransform argument {argument} in tf2 frame_ids "
                f"{problem}"
            )
        if not self._exists(name):
            hint = did_you_mean(name, self._names(), before=" ")
            raise LookupException(
                f'"{name}" passed to lookupTransform argument {argument} does not exist.{hint}'
            )

    def _exists(self, name: str) -> bool:
        return name in self._frames or any(name == frame.parent for frame in self._frames.values())

    def _names(self) -> list[str]:
        parents = (frame.parent for frame in self._frames.values())
        return sorted({*self._frames, *parents})

    def _ancestors(self, name: str) -> list[str]:
        line = {name: None}  # a dictionary, because a search in a long list takes long
        while (frame := self._frames.get(name)) is not None and frame.parent not in line:
            name = frame.parent
            line[name] = None
        return list(line)

    def _path(self, target: str, source: str) -> tuple[list[str], list[str]]:
        """Return the frames below the common ancestor, from source and from target upwards."""
        from_source, from_target = self._ancestors(source), self._ancestors(target)
        others = set(from_target)
        for place, name in enumerate(from_source):
            if name in others:
                return from_source[:place], from_target[: from_target.index(name)]
        raise self._unconnected(target, source)

    def _unconnected(self, target: str, source: str) -> TransformException:
        if any(self._ancestors(name)[-1] in self._frames for name in (source, target)):
            frames = self.all_frames_as_string()
            return LookupException(f"The tf tree is invalid because it contains a loop.\n{frames}")
        return ConnectivityException(
            f"Could not find a connection between '{target}' and '{source}' because they are not "
            "part of the same tree. Tf has two or more unconnected trees."
        )

    def all_frames_as_string(self) -> str:
        """Return one line for each frame, with the name of its parent."""
        with self._changed:
            frames = list(self._frames.values())
            return "".join(
                f"Frame {frame.name} exists with parent {frame.parent}.\n" for frame in frames
            )

    def all_frames_as_yaml(self) -> str:
        """Return the tree as YAML, with parents, rates and times in seconds."""
        with self._changed:
            return "".join(_yaml(frame) for frame in self._frames.values()) or "[]"


def _cache_time_error(value: object) -> WrongTypeError:
    given, advice = described(value), "Duration(seconds=10.0)"
    if is_node(value):
        given, advice = "a node", "Buffer(node=self)"
    return WrongTypeError(f"cache_time must be a Duration, not {given}; write {advice}")


def _yaml(frame: Frame) -> str:
    return (
        f"{frame.name}: \n"
        f"  parent: '{frame.parent}'\n"
        f"  broadcaster: '{frame.authority}'\n"
        f"  rate: {10000.0 if frame.is_static else frame.rate_hz:.3f}\n"
        f"  most_recent_transform: {frame.latest_ns / 1e9:.6f}\n"
        f"  oldest_transform: {frame.oldest_ns / 1e9:.6f}\n"
        f"  buffer_length: {(frame.latest_ns - frame.oldest_ns) / 1e9:.3f}\n"
    )


def _check_type(argument: str, name: object) -> None:
    if not isinstance(name, str):
        raise ArgumentTypeError(argument, "the name of a frame, e.g. 'map'", name)


def _rigid(transform: Any) -> Rigid:
    t, q = transform.translation, transform.rotation
    translation: Vector = (t.x, t.y, t.z)
    rotation: Quaternion = (q.x, q.y, q.z, q.w)
    return Rigid(translation, normalized(rotation))


def _stamped(pose: Rigid, stamp_ns: int, target: str, source: str) -> TransformStamped:
    message = TransformStamped(child_frame_id=source)
    message.header.frame_id = target
    message.header.stamp = Time(nanoseconds=stamp_ns).to_msg()
    place, rotation = message.transform.translation, message.transform.rotation
    place.x, place.y, place.z = pose.translation
    rotation.x, rotation.y, rotation.z, rotation.w = pose.rotation
    return message


def check_time(time: object) -> None:
    """Check that the time of a lookup is not a number or a class.

    Raises:
        ArgumentTypeError: It is one of them.
    """
    if isinstance(time, (int, float, type)):
        raise ArgumentTypeError("time", "a Time, e.g. Time() for the newest transform", time)


def _nanoseconds(time: Any) -> int:
    """Return a `Time` or a time message in nanoseconds."""
    check_time(time)
    return int(
        time.nanoseconds if hasattr(time, "nanoseconds") else Time.from_msg(time).nanoseconds
    )
