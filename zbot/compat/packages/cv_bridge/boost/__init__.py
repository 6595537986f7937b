"""Package of the module `cv_bridge_boost`."""
