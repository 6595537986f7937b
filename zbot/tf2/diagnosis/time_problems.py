"""Problems of the times of transforms: old ones, wrong clocks, and simulated time."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from zbot.tf2.diagnosis import advice
from zbot.tf2.diagnosis.link import OTHER_TIME_NS
from zbot.tf2.diagnosis.problem import Cause, Problem, duration_text

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from zbot.tf2.diagnosis.link import Link
    from zbot.tf2.diagnosis.surroundings import Surroundings

_CLOCK_ERROR_NS = 10**8  #: clocks of machines that are set by the network differ by less
_LATE_NS = 5 * 10**8
_MOST_AHEAD_NS = 2 * 10**9  #: programs such as AMCL stamp their transform ahead, by less than this


@dataclass(frozen=True)
class Need:
    """What needs a transform.

    Attributes:
        stamp_ns: The time of the transform, or 0 for the latest.
        what: The message in words.
        topic: The topic of the message, if it is known.
    """

    stamp_ns: int = 0
    what: str = "the message"
    topic: str = ""


def of_links(links: Sequence[Link], surroundings: Surroundings) -> Iterator[Problem]:
    """Yield all problems of the times of links."""
    moving = [link for link in links if not link.is_static]
    mixed = _mixed(moving)
    if mixed is not None:
        yield mixed
    for link in moving:
        found = _sent_once(link, surroundings) or _stale(link, surroundings)
        found = found or _ahead(link) or _behind(link)
        if found is not None:
            yield found
    if mixed is None:
        yield from _unlike_clock(moving, surroundings)


def of_way(links: Sequence[Link], need: Need, surroundings: Surroundings) -> Problem | None:
    """Return why a transform is missing although its frames are connected, or None.

    Args:
        links: The links between the frames.
        need: What needs the transform.
        surroundings: The time of day, and who publishes.
    """
    moving = [link for link in links if not link.is_static]
    if not moving:
        return None
    stamp_ns = need.stamp_ns or min(link.newest_stamp_ns for link in moving)
    slow = min(moving, key=lambda link: link.newest_stamp_ns)
    young = max(moving, key=lambda link: link.oldest_stamp_ns)
    if slow.newest_stamp_ns >= stamp_ns >= young.oldest_stamp_ns:
        return None
    mixed = _mixed(moving) or _other_time_than(moving[0], need, surroundings.now_ns)
    if mixed is not None:
        return mixed
    if stamp_ns > slow.newest_stamp_ns:
        return _too_new(slow, need, surroundings)
    if not need.stamp_ns:
        return _stale(slow, surroundings) or _apart(slow, young)
    return _too_old(young, need)


def _too_new(link: Link, need: Need, surroundings: Surroundings) -> Problem:
    ahead_ns = need.stamp_ns - surroundings.now_ns
    found = _sent_once(link, surroundings) or _stale(link, surroundings)
    if found is not None:
        return found
    if ahead_ns > _CLOCK_ERROR_NS and not link.has_other_time:
        text = f"{need.what} is stamped in the future: the publisher's clock is "
        text += f"{duration_text(ahead_ns)} ahead"
        return Problem(
            Cause.CLOCK_AHEAD, text, advice.set_clock(need.topic or "TOPIC"), _frames(link)
        )
    found = _behind(link)
    if found is not None:
        return found
    gap = duration_text(need.stamp_ns - link.newest_stamp_ns)
    text = f"{need.what} is {gap} newer than the newest transform {link.name}"
    return Problem(Cause.FUTURE, text, advice.wait_for(link), _frames(link))


def _too_old(link: Link, need: Need) -> Problem:
    ahead = _ahead(link)
    if ahead is not None and need.stamp_ns >= link.oldest_stamp_ns - link.lead_ns:
        return ahead
    gap = duration_text(link.newest_stamp_ns - need.stamp_ns)
    known = duration_text(link.newest_stamp_ns - link.oldest_stamp_ns)
    text = f"{need.what} is {gap} older than the newest transform {link.name}; only the last "
    text += f"{known} are known"
    return Problem(Cause.PAST, text, advice.measure_delay(need.topic), _frames(link))


def _apart(slow: Link, young: Link) -> Problem:
    gap = duration_text(young.newest_stamp_ns - slow.newest_stamp_ns)
    text = f"the stamps of {slow.name} ({advice.who(slow)}) are {gap} older than those of "
    text += young.name
    return Problem(Cause.CLOCK_BEHIND, text, advice.set_clock(""), _frames(slow))


def _mixed(moving: Sequence[Link]) -> Problem | None:
    """Return the problem that some links have the time of day, and others do not."""
    other = [link for link in moving if link.has_other_time]
    real = [link for link in moving if not link.has_other_time]
    if not (other and real):
        return None
    text = (
        f"`{other[0].name}` ({advice.who(other[0])}) has simulated or recorded time, and "
        f"`{real[0].name}` ({advice.who(real[0])}) has the time of day"
    )
    nodes = sorted({name for link in real for name in link.nodes})
    frames = (*_frames(other[0]), *_frames(real[0]))
    return Problem(Cause.MIXED_TIME, text, advice.use_sim_time(nodes), frames)


def _other_time_than(link: Link, need: Need, now_ns: int) -> Problem | None:
    """Return the problem that a message and a link have different kinds of time."""
    is_other = abs(need.stamp_ns - now_ns) > OTHER_TIME_NS
    if not need.stamp_ns or is_other == link.has_other_time:
        return None
    kinds = ("the time of day", "simulated or recorded time")
    text = (
        f"{need.what} has {kinds[is_other]}, and the transform {link.name} ({advice.who(link)}) "
        f"has {kinds[not is_other]}"
    )
    nodes = link.nodes if is_other else []
    return Problem(Cause.MIXED_TIME, text, advice.use_sim_time(nodes), _frames(link))


def _unlike_clock(moving: Sequence[Link], surroundings: Surroundings) -> Iterator[Problem]:
    """Yield the problem that `/clock` and the transforms do not belong together."""
    for link in moving[:1]:
        if link.has_other_time == surroundings.has_clock:
            return
        frames = _frames(link)
        if surroundings.has_clock:
            text = (
                f"/clock is published, but `{link.name}` ({advice.who(link)}) has the time of day"
            )
            action = advice.use_sim_time(link.nodes)
        else:
            text = f"`{link.name}` ({advice.who(link)}) has simulated or recorded time, but nobody "
            text += "publishes /clock"
            action = "for a bag, type: zbot bag play BAG --clock"
        yield Problem(Cause.MIXED_TIME, text, action, frames, is_warning=True)


def _sent_once(link: Link, surroundings: Surroundings) -> Problem | None:
    """Return the problem that a transform that does not change is on the wrong topic, or None."""
    has_stopped = link.is_stale(surroundings.now_ns) and not surroundings.has_ended(link)
    is_single = link.count == 1 and has_stopped
    is_frozen = link.count > 1 and link.repetitions == link.count - 1
    if link.pose_changes or not (is_single or is_frozen):
        return None
    how = "only once" if is_single else "again and again with the same stamp"
    text = f"`{link.name}` ({advice.who(link)}) came {how}; only /tf_static keeps a transform"
    action = "publish it with a StaticTransformBroadcaster, or type: "
    action += advice.publish_static(link.parent, link.child)
    return Problem(Cause.STATIC_ON_TF, text, action, _frames(link))


def _stale(link: Link, surroundings: Surroundings) -> Problem | None:
    if not link.is_stale(surroundings.now_ns):
        return None
    silence = duration_text(link.silence_ns(surroundings.now_ns))
    text = f"`{link.name}` ({advice.who(link)}) was last heard {silence} ago"
    if surroundings.has_ended(link):
        text += ": its node has ended"
        return Problem(Cause.STALE, text, advice.start_again(link.nodes), _frames(link))
    return Problem(Cause.STALE, text, advice.look_at_output(link), _frames(link))


def _ahead(link: Link) -> Problem | None:
    lead_ns = link.lead_ns
    if lead_ns <= _CLOCK_ERROR_NS or link.has_other_time:
        return None
    lead, clock_ns = duration_text(lead_ns), link.clock_lead_ns
    if clock_ns is None or clock_ns > _CLOCK_ERROR_NS / 2:
        text = f"the publisher's clock is {lead} ahead: `{link.name}` ({advice.who(link)}) is "
        text += "stamped in the future"
        return Problem(Cause.CLOCK_AHEAD, text, advice.set_clock(""), _frames(link))
    text = f"`{link.name}` ({advice.who(link)}) is stamped {lead} ahead, although the clock of "
    text += "its machine is right"
    is_usual = lead_ns <= _MOST_AHEAD_NS
    return Problem(
        Cause.STAMPED_AHEAD, text, advice.stamp_now(), _frames(link), is_warning=is_usual
    )


def _behind(link: Link) -> Problem | None:
    if link.lead_ns >= -_LATE_NS or link.has_other_time:
        return None
    late = duration_text(link.lead_ns)
    text = f"`{link.name}` ({advice.who(link)}) arrives with stamps that are {late} old"
    if link.clock_lead_ns is not None and link.clock_lead_ns < -_LATE_NS:
        text += ": the publisher's clock is behind, or its messages take so long"
    return Problem(Cause.CLOCK_BEHIND, text, advice.set_clock(""), _frames(link))


def _frames(link: Link) -> tuple[str, str]:
    return link.parent, link.child
