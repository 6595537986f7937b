"""Tags of Gazebo that have no effect in the simulator, e.g. because MuJoCo's contacts differ."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.simulation.gazebo.tags import flag, number

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator
    from xml.etree.ElementTree import Element

_UNUSED = frozenset(
    {
        *("kp", "kd", "minDepth", "min_depth", "maxVel", "max_vel", "maxContacts", "max_contacts"),
        *("slip1", "slip2", "springStiffness", "spring_stiffness"),
    }
)
#: Tags that ask for something else than what the simulator does, if they have this value.
_ODD_FLAGS = {"selfCollide": True, "self_collide": True, "turnGravityOff": True, "gravity": False}
_OTHERS = frozenset({"sensor", "plugin", "visual"})


def unused_tags(element: Element) -> set[str]:
    """Return the tags in a `<gazebo>` or `<model>` that have no effect.

    Raises:
        DescriptionError: A friction is not a number.
    """
    found: set[str] = set()
    for parent in _own_tags(element):
        for tag in parent:
            odd = _ODD_FLAGS.get(tag.tag)
            if tag.tag in _UNUSED or (odd is not None and flag(tag, not odd, tag.tag) is odd):
                found.add(tag.tag)
        found |= _direction(parent)
    return found


def _direction(parent: Element) -> set[str]:
    """Return the tags of a friction that differs between two directions."""
    tags = {tag.tag: tag for tag in parent}
    along, across = tags.get("mu1", tags.get("mu")), tags.get("mu2")
    if across is None or number(along, 1.0, "mu1", "mu") == number(across, 1.0, "mu2"):
        return set()
    return {"mu2", "fdir1"} & tags.keys()


def _own_tags(element: Element) -> Iterator[Element]:
    """Yield an element and those in it, without its sensors and plugins."""
    yield element
    for child in element:
        if child.tag not in _OTHERS:
            yield from _own_tags(child)


def unused_notice(tags: Iterable[str]) -> list[str]:
    """Return the line about tags that have no effect, or nothing."""
    names = [f"<{tag}>" for tag in sorted(tags)]
    if not names:
        return []
    return [f"what {', '.join(names)} {'says' if len(names) == 1 else 'say'}"]
