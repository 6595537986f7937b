"""Panel Layout of the live page."""
