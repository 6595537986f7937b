"""Log the messages of student_publisher, as the subscriber of the assignment.

Run:        zbot run student_subscriber
Subscribes: student_id (std_msgs/String) and random_number (std_msgs/Int32)
"""

import zbot

from std_msgs.msg import Int32, String


class StudentSubscriber(zbot.Node):
    """Logs each student id and each number."""

    def __init__(self) -> None:
        super().__init__("student_subscriber")
        self.id_subscription = self.create_subscription(String, "student_id", self.hear_id, 10)
        self.number_subscription = self.create_subscription(
            Int32, "random_number", self.hear_number, 10
        )

    def hear_id(self, msg: String) -> None:
        """Log one student id."""
        self.get_logger().info(f"Received student ID: {msg.data}")

    def hear_number(self, msg: Int32) -> None:
        """Log one number."""
        self.get_logger().info(f"Received random number: {msg.data}")


def main() -> None:
    """Run until Ctrl-C."""
    with zbot.init():
        zbot.spin(StudentSubscriber())


if __name__ == "__main__":
    main()
