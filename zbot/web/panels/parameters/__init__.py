"""Panel Parameters of the live page."""
