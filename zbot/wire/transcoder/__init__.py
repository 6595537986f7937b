"""Conversion of messages from CDR to MessagePack and back, without message objects."""
