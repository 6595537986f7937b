"""Hub of a machine: a Zenoh router of its own, and the process that runs it."""
