"""Nodes of topic_tools, which pass on messages of any type without reading them."""
