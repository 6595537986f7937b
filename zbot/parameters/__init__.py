"""Parameters: their values, types, ranges and files, and the `--ros-args` of a command line."""
