"""`ComposableNode` under its own module's name."""

from zbot.launch.actions.composable import ComposableNode
