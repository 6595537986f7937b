"""Panel Diagnostics of the live page."""
