"""WebSockets with the rosbridge v2 protocol, through which web programs use the system."""
