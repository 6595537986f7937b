"""Programs that show the frames of a robot."""
