"""Security between machines: secrets, certificates and the access rules of a hub."""
