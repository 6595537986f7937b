"""`Parser` under its own module's name."""

from zbot.launch.frontend.parser import Parser
