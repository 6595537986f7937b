"""The panels of the live page, in the order of its list."""

from zbot.web.panels import plot, topics

PANELS = (
    topics.PANEL,
    plot.PANEL,
)
