"""Panel Topics of the live page."""
