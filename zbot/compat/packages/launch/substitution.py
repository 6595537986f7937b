"""`Substitution` under its own module's name."""

from zbot.launch import Substitution
