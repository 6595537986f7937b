"""What rclpy is made of, as far as programs use it."""
