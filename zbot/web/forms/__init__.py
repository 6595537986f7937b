"""Forms for the fields of a message."""
