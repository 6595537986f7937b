"""Draws directed graphs in layers, from left to right (Sugiyama, Tagawa and Toda, 1981).

Pure, deterministic, and made for pictures that change: given the layout that was on the screen,
what is there already stays where it is as far as possible.
"""

from zbot.graph.layout.graph import Frame, Item, Layout, Link, Place, Route
from zbot.graph.layout.layout import lay_out

__all__ = ["Frame", "Item", "Layout", "Link", "Place", "Route", "lay_out"]
