"""`StateTransition` under its own module's name."""

from zbot.launch.lifecycle_event import StateTransition
