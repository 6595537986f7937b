"""Panel Graph of the live page."""
