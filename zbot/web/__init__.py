"""Live page, which a web server provides to show a domain's running nodes in a browser."""
