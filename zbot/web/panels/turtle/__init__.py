"""Panel Turtle of the live page."""
