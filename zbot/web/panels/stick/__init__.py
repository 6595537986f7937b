"""Panel Stick of the live page."""
