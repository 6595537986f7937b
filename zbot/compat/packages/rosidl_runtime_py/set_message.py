"""Messages filled from dictionaries."""

from zbot.interfaces.set_fields import set_message_fields as set_message_fields
