"""Values of plugins and sensors of Gazebo, which have many names for the same value."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.libraries.robot_description.xml_text import numbers

if TYPE_CHECKING:
    from xml.etree.ElementTree import Element

_TRUE = frozenset({"1", "true"})


def first(element: Element | None, *tags: str) -> Element | None:
    """Return the first element with one of these tags, at any depth."""
    if element is None:
        return None
    for tag in tags:
        found = next(element.iter(tag), None)
        if found is not None:
            return found
    return None


def word(element: Element | None, default: str, *tags: str) -> str:
    """Return the text of the first element with one of these tags."""
    found = first(element, *tags)
    return (found.text or "").strip() if found is not None else default


def words(element: Element, *tags: str) -> tuple[str, ...]:
    """Return the texts of all elements with one of these tags."""
    texts = ((found.text or "").strip() for found in element.iter() if found.tag in tags)
    return tuple(text for text in texts if text)


def number(element: Element | None, default: float, *tags: str) -> float:
    """Return the number in the first element with one of these tags.

    Raises:
        DescriptionError: The text is not a number.
    """
    found = first(element, *tags)
    if found is None:
        return default
    text = (found.text or "").strip() or found.get("value", "")
    return numbers(text, 1, f"<{found.tag}> in <gazebo>")[0]


def flag(element: Element | None, default: bool, *tags: str) -> bool:
    """Return the truth value in the first element with one of these tags."""
    text = word(element, "", *tags).lower()
    return text in _TRUE if text else default


def file_of(plugin: Element) -> str:
    """Return the file and the name of a plugin. Both say what it is."""
    return f"{plugin.get('filename', '')} {plugin.get('name', '')}"


def is_classic(element: Element) -> bool:
    """Return whether a plugin, or the plugin of a sensor, is one of Gazebo Classic for ROS."""
    plugins = [element] if element.tag == "plugin" else element.findall("plugin")
    return any("gazebo_ros" in file_of(plugin) for plugin in plugins)
