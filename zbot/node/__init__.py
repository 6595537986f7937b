"""Nodes and their entities: publishers, subscriptions, services, clients, parameters."""
