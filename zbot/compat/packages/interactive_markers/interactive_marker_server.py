"""The same name under its own module."""

from zbot.libraries.interactive_markers import InteractiveMarkerServer
