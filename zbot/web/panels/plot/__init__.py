"""Panel Plot of the live page."""
