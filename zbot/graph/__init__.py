"""Graph of a domain, with nodes, topics and services, and the drawing of the graph."""
