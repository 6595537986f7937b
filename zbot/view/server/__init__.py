"""Server of the 3D view: viser's server behind a guard, and the address for the browser."""
