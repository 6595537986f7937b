"""Messages as text and dictionaries."""

from zbot.message_conversion import convert_value as _convert_value
from zbot.message_conversion import get_message_slot_types as get_message_slot_types
from zbot.message_conversion import message_to_csv as message_to_csv
from zbot.message_conversion import message_to_ordereddict as message_to_ordereddict
from zbot.message_conversion import message_to_yaml as message_to_yaml
