"""The bundled nodes: each one is a page that can be read aloud."""
