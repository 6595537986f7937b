"""Names of `launch.utilities` under the name of their own module."""

from zbot.launch.visit import (
    visit_all_entities_and_collect_futures,
)
