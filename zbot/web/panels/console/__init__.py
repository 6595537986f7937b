"""Panel Console of the live page."""
