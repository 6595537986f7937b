"""Input of the command line: options, types and message values."""
