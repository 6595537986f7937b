"""Layered layout of directed graphs, from left to right (Sugiyama, Tagawa and Toda, 1981).

The result is deterministic. If the previous layout is given, items keep their places where
possible, so that users can follow the changes of a graph.
"""

from zbot.graph.layout.geometry import Frame, Item, Layout, Link, Place, Route
from zbot.graph.layout.layout import lay_out

__all__ = ["Frame", "Item", "Layout", "Link", "Place", "Route", "lay_out"]
