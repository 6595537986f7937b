"""Parts of the turtle simulator: its world, the drawing of the turtles, and the keyboard."""
