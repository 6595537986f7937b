"""Executors, and all that waits in them: tasks, timers, clocks, callback groups."""
