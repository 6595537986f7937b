"""The terminal: text that is safe to print on it, and keys that are pressed in it."""
