"""Broadcasters of transforms that never change."""

from zbot.tf2.broadcaster import StaticTransformBroadcaster
