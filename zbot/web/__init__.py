"""Live page: a web server that shows a domain's running nodes in a browser."""
