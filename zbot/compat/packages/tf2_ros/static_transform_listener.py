"""Listeners to transforms that never change."""

from zbot.tf2.listener import StaticTransformListener
