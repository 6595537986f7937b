"""Wire format: Zenoh keys with names, liveliness tokens with QoS, and payloads with messages.

The modules here use only text and bytes, not Zenoh. `docs/wire.md` describes the format.
"""
