"""Who may do what between machines: secrets, certificates, and the rules that a hub enforces."""
