"""Zenoh sessions, the meeting port, queries of the admin space, and the configuration."""
