"""Broadcasters of transforms that hold for ever."""

from zbot.tf2.broadcaster import StaticTransformBroadcaster as StaticTransformBroadcaster
