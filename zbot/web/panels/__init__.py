"""The panels of the live page, in the order of its list."""

from zbot.web.panels import classroom, plot, topics

PANELS = (
    topics.PANEL,
    plot.PANEL,
    classroom.PANEL,
)
