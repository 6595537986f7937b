"""Substitutions with the values true and false."""

from zbot.launch.substitutions import (
    AllSubstitution,
    AndSubstitution,
    AnySubstitution,
    NotSubstitution,
    OrSubstitution,
)
