"""The log of a launch, itself: what a test replaces here is replaced for every launch."""

import sys

from zbot.launch import log

sys.modules[f"{__name__}.handlers"] = log.handlers
sys.modules[__name__] = log
