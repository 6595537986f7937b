"""ros2_control: the controller manager, its controllers, and a hardware that is simulated."""
