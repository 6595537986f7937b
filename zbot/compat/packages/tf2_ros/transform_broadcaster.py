"""Broadcasters of transforms that change."""

from zbot.tf2.broadcaster import TransformBroadcaster
