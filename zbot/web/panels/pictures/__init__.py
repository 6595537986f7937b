"""Panel Pictures of the live page."""
