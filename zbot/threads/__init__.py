"""Tools for code that several threads run: deadlines, wake-ups, weak sets, calls from Zenoh."""
