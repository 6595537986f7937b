"""A buffer of another node."""

from zbot.tf2.remote_buffer import BufferClient
