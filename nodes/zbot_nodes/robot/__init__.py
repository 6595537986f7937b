"""World and pose of the simulated robot, which its nodes share."""
