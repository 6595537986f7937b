"""Graph of a domain: its nodes, topics and services, and the drawing of them."""
