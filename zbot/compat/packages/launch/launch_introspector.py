"""`LaunchIntrospector` under its own module's name."""

from zbot.launch import LaunchIntrospector
