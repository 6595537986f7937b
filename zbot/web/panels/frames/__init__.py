"""Panel Frames of the live page."""
