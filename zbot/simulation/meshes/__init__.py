"""Meshes: files with triangles, and the convex solids that the physics makes from them."""
