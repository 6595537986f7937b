"""Robots: bodies, drives and equipment from robot descriptions."""
