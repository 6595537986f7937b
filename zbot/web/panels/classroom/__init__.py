"""Panel Class of the live page."""
