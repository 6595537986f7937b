"""Panel View of the live page."""
