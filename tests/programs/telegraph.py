"""Telegraph office that logs at every level, now and then, and in a branch office."""

import rclpy
from rclpy.logging import LoggingSeverity, get_logger, set_logger_level

rclpy.init()
office = rclpy.create_node("telegraph", namespace="station")
log = office.get_logger()
log.debug("unheard")
log.set_level(LoggingSeverity.DEBUG)
log.debug("key pressed")
log.info("wire sent")
log.warning("rain on the wire")
log.error("wire broken")
log.fatal("pole fallen")
for dots in range(4):
    log.info(f"once {dots}", once=True)
    log.info(f"skipping {dots}", skip_first=True)
    log.info(f"seldom {dots}", throttle_duration_sec=1000.0)
branch = log.get_child("branch")
branch.info("from the branch")
set_logger_level("clerk", LoggingSeverity.ERROR)
get_logger("clerk").warning("unheard")
get_logger("clerk").error("ink is out")
print(log.name, branch.get_effective_level().name, log.is_enabled_for(LoggingSeverity.DEBUG))
rclpy.shutdown()
