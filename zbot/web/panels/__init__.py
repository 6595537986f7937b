"""Panels of the live page, in the order in which the page lists them."""

from zbot.web.panels import actions, classroom, console, plot, services
from zbot.web.panels.bags import panel as bags
from zbot.web.panels.diagnostics import panel as diagnostics
from zbot.web.panels.drive import panel as drive
from zbot.web.panels.frames import panel as frames
from zbot.web.panels.graph import panel as graph
from zbot.web.panels.joints import panel as joints
from zbot.web.panels.launch import panel as launch
from zbot.web.panels.layout import panel as layout
from zbot.web.panels.parameters import panel as parameters
from zbot.web.panels.pictures import panel as pictures
from zbot.web.panels.processes import panel as processes
from zbot.web.panels.sensors import panel as sensors
from zbot.web.panels.topics import panel as topics
from zbot.web.panels.turtle import panel as turtle
from zbot.web.panels.view import panel as view

PANELS = (
    graph.PANEL,
    topics.PANEL,
    plot.PANEL,
    frames.PANEL,
    view.PANEL,
    pictures.PANEL,
    turtle.PANEL,
    drive.PANEL,
    joints.PANEL,
    sensors.PANEL,
    services.PANEL,
    actions.PANEL,
    parameters.PANEL,
    console.PANEL,
    diagnostics.PANEL,
    bags.PANEL,
    processes.PANEL,
    launch.PANEL,
    classroom.PANEL,
    layout.PANEL,
)
