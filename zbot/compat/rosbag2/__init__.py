"""Classes of `rosbag2_py`, which write, read, record and play bags."""
