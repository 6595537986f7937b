"""Zenoh: sessions, the meeting point, queries of the admin space, the configuration."""
