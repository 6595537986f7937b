"""Panel Services of the live page."""
