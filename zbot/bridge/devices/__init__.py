"""Things that are not zbot: boards on a cable, and what an MQTT broker has.

They send texts, e.g. lines. `text_value.py` reads numbers and words from a text, `topic_type.py`
chooses the types of topics, and `topic_publishers.py` publishes. `topic_subscriptions.py` sends
messages the other way. `tally.py` counts what was lost.
"""

from __future__ import annotations
