"""Node of the simulator: its topics, its services and its time."""
