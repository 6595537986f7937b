"""Checks of a package for errors that would show when it runs, by kind of file."""
