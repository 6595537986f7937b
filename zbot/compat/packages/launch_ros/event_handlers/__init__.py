"""What to do when a managed node changes its state."""

from zbot.launch.lifecycle_event import OnStateTransition as OnStateTransition
