"""Handlers that do something when a managed node changes its state."""

from zbot.launch.lifecycle_event import OnStateTransition
