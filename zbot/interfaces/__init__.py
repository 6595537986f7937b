"""ROS 2 interface definitions, and the Python classes made from them."""
