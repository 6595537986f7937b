"""Panel Drive of the live page."""
