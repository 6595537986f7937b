"""ROS 2's `test_msgs`: types for tests. zbot makes `msg`, `srv` and `action` at their import."""
