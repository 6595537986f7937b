"""Panel Joints of the live page."""
