"""What test files write above functions."""

from zbot.launch.testing.marker import keep_alive as keep_alive
from zbot.launch.testing.marker import retry_on_failure as retry_on_failure
