"""Web programs' way into the system: WebSockets that speak the rosbridge v2 protocol."""
