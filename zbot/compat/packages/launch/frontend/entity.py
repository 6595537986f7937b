"""`Entity` under its own module's name."""

from zbot.launch.frontend.entity import Entity
