"""Panels of the live page, in the order in which the page lists them."""

from zbot.web.panels import (
    actions,
    bags,
    classroom,
    console,
    graph,
    parameters,
    plot,
    processes,
    services,
    stick,
    topics,
    turtle,
)

PANELS = (
    graph.PANEL,
    topics.PANEL,
    plot.PANEL,
    turtle.PANEL,
    stick.PANEL,
    services.PANEL,
    actions.PANEL,
    parameters.PANEL,
    console.PANEL,
    bags.PANEL,
    processes.PANEL,
    classroom.PANEL,
)
