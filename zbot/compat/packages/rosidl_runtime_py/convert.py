"""Messages as text and dictionaries."""

from zbot.interfaces.conversion import convert_value as _convert_value
from zbot.interfaces.conversion import get_message_slot_types as get_message_slot_types
from zbot.interfaces.conversion import message_to_csv as message_to_csv
from zbot.interfaces.conversion import message_to_ordereddict as message_to_ordereddict
from zbot.interfaces.conversion import message_to_yaml as message_to_yaml
