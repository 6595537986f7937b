"""Panel Launch of the live page."""
