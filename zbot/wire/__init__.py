"""The wire contract: how names, qualities and messages become Zenoh's keys and bytes.

Pure text and bytes, no Zenoh; `docs/wire.md` is its prose.
"""
