"""Panel Bags of the live page."""
