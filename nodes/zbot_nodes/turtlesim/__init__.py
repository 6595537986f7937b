"""The turtle simulator: its world, what turtles draw, and the keyboard."""
