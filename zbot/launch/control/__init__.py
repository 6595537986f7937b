"""Control of a running launch by the page: its processes, their output, restart and stop."""
