"""Tools for code that several threads run: wake-ups, weak sets, and calls from Zenoh's threads."""
