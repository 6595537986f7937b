"""Panel Processes of the live page."""
