"""Listeners to what holds for ever."""

from zbot.tf2.listener import StaticTransformListener as StaticTransformListener
