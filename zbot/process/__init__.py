"""Changes to the host process: signal handlers, exit functions, exception hooks and memory."""
