"""Buffers of transforms."""

from zbot.tf2.buffer import Buffer
