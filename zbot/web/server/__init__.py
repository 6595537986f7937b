"""Server of the live page: its process, its address on this machine, and the check of requests."""
