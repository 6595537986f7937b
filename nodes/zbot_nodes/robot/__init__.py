"""What the nodes of the simulated robot share: its world, and how it says where it is."""
