"""Listeners."""

from zbot.tf2.listener import TransformListener
