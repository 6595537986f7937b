"""Parameters, their types, ranges and files, and parsing of `--ros-args` in a command line."""
