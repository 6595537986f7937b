"""What `launch.utilities` has, under its own module's name."""

from zbot.launch.visit import (
    visit_all_entities_and_collect_futures as visit_all_entities_and_collect_futures,
)
