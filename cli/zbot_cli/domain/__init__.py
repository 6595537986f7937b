"""Access of the command to the nodes of its domain: the graph, parameters, states and types."""
