"""Server for Foxglove and Lichtblick, with the package `foxglove-sdk`."""
