"""Checks that find the errors of a package before it runs."""
