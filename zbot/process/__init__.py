"""Changes to the host process: signal handlers, the exit, hooks, the garbage collector, the allocator."""
