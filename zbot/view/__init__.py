"""3D view of a domain in a browser: the displays of rviz, drawn with the library viser."""
