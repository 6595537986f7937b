"""Start of a bundled node."""
