"""Constants of rclpy's modules."""

from __future__ import annotations

HIDDEN_NODE_PREFIX = "_"
HIDDEN_TOPIC_PREFIX = "_"
PARAMETER_SEPARATOR_STRING = "."
START_TYPE_DESCRIPTION_SERVICE_PARAM = "start_type_description_service"
TOPIC_SEPARATOR_STRING = "/"
USE_SIM_TIME_NAME = "use_sim_time"
