"""`Entity` under its own module's name."""

from zbot.launch.frontend.xml_file import Entity
