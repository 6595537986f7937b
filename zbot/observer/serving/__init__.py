"""Servers for browsers: their addresses, their ports, and the browser of this machine."""
