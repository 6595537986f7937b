"""Panels of the live page, in the order in which the page lists them."""

from zbot.web.panels import actions
from zbot.web.panels.bags import panel as bags
from zbot.web.panels.classroom import panel as classroom
from zbot.web.panels.console import panel as console
from zbot.web.panels.graph import panel as graph
from zbot.web.panels.parameters import panel as parameters
from zbot.web.panels.plot import panel as plot
from zbot.web.panels.processes import panel as processes
from zbot.web.panels.services import panel as services
from zbot.web.panels.stick import panel as stick
from zbot.web.panels.topics import panel as topics
from zbot.web.panels.turtle import panel as turtle

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
