"""Clients of other nodes: their parameters, life cycles, types, profiles and messages."""
