"""MessagePack, the format of messages in zbot's own dialect."""
