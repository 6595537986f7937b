"""ROS 2's `test_msgs`: types made to be tested with; `msg`, `srv` and `action` are found beside."""
