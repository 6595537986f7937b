"""Names of the topics and frames of sensors and plugins."""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol

from zbot.simulation.gazebo.tags import is_classic, word

if TYPE_CHECKING:
    from collections.abc import Mapping
    from xml.etree.ElementTree import Element

#: Text before the name of a topic of Gazebo, which a bridge connects with ROS.
TRANSPORT = "gz-transport:"
FRAME_TAGS = (
    *("frame_name", "frameName", "optical_frame_id", "gz_frame_id", "ignition_frame_id"),
    "frame_id",
)


class Names(Protocol):
    """Names of one robot's topics and frames."""

    model: str  #: name of the robot

    def topic(self, element: Element, classic: str, gz: str, *tags: str) -> str:
        """Return the topic of a sensor or plugin.

        Args:
            element: The sensor or plugin.
            classic: The usual topic of Gazebo Classic. It also is the name in remappings.
            gz: The usual topic of the new Gazebo.
            tags: The tags with the topic.
        """
        ...

    def of_sensor(self, link: str, sensor: str, last: str) -> str:
        """Return the usual topic of a sensor in the new Gazebo."""
        ...

    def frame(self, element: Element, link: str) -> str:
        """Return the frame of a sensor's messages."""
        ...

    def link_frame(self, link: str) -> str:
        """Return the usual frame of a link in the new Gazebo."""
        ...

    def tf(self, plugin: Element, wanted: bool) -> str:
        """Return the topic of a plugin's transforms. Empty means that it publishes none."""
        ...


class PlainNames:
    """Names in which only the last word counts, so that each robot has its own namespace."""

    model = ""

    def topic(self, element: Element, classic: str, gz: str, *tags: str) -> str:
        """Return the last word of a topic, or a remapping of it."""
        for rule in (*element.iter("remapping"), *element.iter("argument")):
            before, _, after = (rule.text or "").strip().partition(":=")
            start = classic.lstrip("~/").partition("/")[0]
            if before.strip().lstrip("~/").partition("/")[0] == start and after:
                return after.strip()
        usual = gz.rpartition("/")[2]
        return word(element, usual, *tags).rpartition("/")[2] or usual

    def of_sensor(self, link: str, sensor: str, last: str) -> str:  # noqa: ARG002 - as the protocol
        """Return the kind of the sensor."""
        return last

    def frame(self, element: Element, link: str) -> str:  # noqa: ARG002 - as the protocol
        """Return the frame in the description, or an empty text for the link."""
        return word(element, "", *FRAME_TAGS)

    def link_frame(self, link: str) -> str:
        """Return the link."""
        return link

    def tf(self, plugin: Element, wanted: bool) -> str:  # noqa: ARG002 - as the protocol
        """Return ROS 2's topic."""
        return "/tf"


class GazeboNames:
    """Names as in Gazebo.

    Args:
        model: The name of the robot.
        world: The name of the world.
        lumped: For each link that a fixed joint connects with another link: that link.
        namespace: The namespace that the spawning program gave.
    """

    def __init__(
        self, model: str, world: str, lumped: Mapping[str, str] | None = None, namespace: str = ""
    ) -> None:
        self.model, self.world = model, world
        self._lumped, self._namespace = lumped or {}, namespace.strip("/")

    def topic(self, element: Element, classic: str, gz: str, *tags: str) -> str:
        """Return the topic of ROS, or that of Gazebo with `TRANSPORT` before it."""
        given = word(element, "", *tags)
        if given == "__default_topic__":
            given = ""
        if not is_classic(element):
            return f"{TRANSPORT}/{(given or gz).strip('/')}"
        plugin = element if element.tag == "plugin" else _plugin(element)
        given = word(plugin, "", *tags)
        return self._remapped(plugin, given or classic)

    def _remapped(self, plugin: Element, topic: str) -> str:
        ros = plugin.find("ros")
        own = word(ros, "", "namespace").strip("/")
        start = "/" + "/".join(part for part in (self._namespace, own) if part)

        def expanded(name: str) -> str:
            if name.startswith("~"):
                name = f"{plugin.get('name', '')}{name[1:]}"
            return name if name.startswith("/") else f"{start.rstrip('/')}/{name}"

        rules = {}
        for rule in (*plugin.iter("remapping"), *plugin.iter("argument")):
            before, _, after = (rule.text or "").strip().partition(":=")
            rules[expanded(before.strip())] = expanded(after.strip())
        return rules.get(expanded(topic), expanded(topic))

    def of_sensor(self, link: str, sensor: str, last: str) -> str:
        """Return the topic that has the place of a sensor in the world."""
        at = self._lumped.get(link, link)
        return f"/world/{self.world}/model/{self.model}/link/{at}/sensor/{sensor}/{last}"

    def frame(self, element: Element, link: str) -> str:
        """Return the frame in the description, or Gazebo's name of the sensor or its link."""
        given = word(element, "", *FRAME_TAGS)
        if given:
            return given
        at = self._lumped.get(link, link)
        return at if is_classic(element) else f"{self.model}/{at}/{element.get('name', '')}"

    def link_frame(self, link: str) -> str:
        """Return the name of a link with that of its model."""
        return f"{self.model}/{self._lumped.get(link, link)}"

    def tf(self, plugin: Element, wanted: bool) -> str:
        """Return `/tf` for a plugin of ROS, and the plugin's own topic in the new Gazebo."""
        if is_classic(plugin):
            return "/tf" if wanted else ""
        return self.topic(plugin, "tf", f"/model/{self.model}/tf", "tf_topic")


def _plugin(sensor: Element) -> Element:
    """Return the plugin of a sensor."""
    plugins = sensor.findall("plugin")
    return next((plugin for plugin in plugins if is_classic(plugin)), sensor)
