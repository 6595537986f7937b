"""Changes to the host process: signal handlers, the exit, hooks, memory."""
