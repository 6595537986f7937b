"""Topics of an MQTT broker: `address.py`, `client.py` connects, `broker.py` links."""

from __future__ import annotations
