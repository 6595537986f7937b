"""Functions that fill messages from dictionaries."""

from zbot.interfaces.set_fields import set_message_fields
