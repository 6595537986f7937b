"""Domain of the running nodes: the command's client, and what it asks them."""
