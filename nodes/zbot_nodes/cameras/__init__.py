"""Cameras: drivers of webcams, and programs that show and rectify their images."""
