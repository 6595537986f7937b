"""Executors, and the objects that they run or use: tasks, timers, clocks and callback groups."""
