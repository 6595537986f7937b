"""Panels of the live page, in the order in which the page lists them."""

from zbot.web.panels import (
    actions,
    classroom,
    console,
    graph,
    parameters,
    plot,
    processes,
    services,
    topics,
    turtle,
)

PANELS = (
    graph.PANEL,
    topics.PANEL,
    plot.PANEL,
    turtle.PANEL,
    services.PANEL,
    actions.PANEL,
    parameters.PANEL,
    console.PANEL,
    processes.PANEL,
    classroom.PANEL,
)
