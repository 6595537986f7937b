"""Publish a student id and a random number: the publisher of the assignment.

Run:       zbot run student_publisher              (or: zbot run student_publisher S1234567)
Publishes: student_id (std_msgs/String) and random_number (std_msgs/Int32), once a second
"""

import random
import sys

import zbot

from std_msgs.msg import Int32, String


class StudentPublisher(zbot.Node):
    """Publishes the student id and a number from 1 to 100, every second.

    Args:
        student_id: The id to publish.
    """

    def __init__(self, student_id: str) -> None:
        super().__init__("student_publisher")
        self.student_id = student_id
        self.id_publisher = self.create_publisher(String, "student_id", 10)
        self.number_publisher = self.create_publisher(Int32, "random_number", 10)
        self.timer = self.create_timer(1.0, self.publish_both)

    def publish_both(self) -> None:
        """Publish the id and a new number."""
        number = random.randint(1, 100)
        self.id_publisher.publish(String(data=self.student_id))
        self.number_publisher.publish(Int32(data=number))
        self.get_logger().info(f"Student ID: {self.student_id}, random number: {number}")


def main() -> None:
    """Run until Ctrl-C."""
    words = [word for word in sys.argv[1:2] if not word.startswith("-")]
    with zbot.init():
        zbot.spin(StudentPublisher(*words or ["S0000000"]))


if __name__ == "__main__":
    main()
