"""Classes and hubs: many machines, each with a hub (a Zenoh router) that dials one common hub."""
