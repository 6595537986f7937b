"""Messages filled from dictionaries."""

from zbot.message_fields import set_message_fields as set_message_fields
