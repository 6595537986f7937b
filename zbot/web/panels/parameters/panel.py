"""Panel of one node's parameters. Each parameter has an input for its type and range."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.remote.parameters import nodes_with_parameters
from zbot.web.page.list_panel import ListPanel
from zbot.web.page.panel import Page, Panel
from zbot.web.page.table import Cell, Column
from zbot.web.panels.parameters.node_parameters import NodeParameters

if TYPE_CHECKING:
    from zbot.graph.snapshot import Snapshot


def _build(page: Page) -> None:
    ListPanel(
        page,
        columns=(Column("Node", "zb-mono zb-cut"),),
        rows=_rows,
        details=NodeParameters,
        key="node",
        command="zbot param list",
        empty="No node with parameters yet: start one, e.g. zbot run parameter_demo",
        hidden="Hidden nodes",
        is_narrow=True,
    )


def _rows(graph: Snapshot, hidden: bool) -> dict[str, list[str | Cell]]:
    nodes = nodes_with_parameters(graph, include_hidden=hidden)
    return {node: [Cell(node, hint=node)] for node in nodes}


PANEL = Panel("/parameters", "Parameters", "tune", _build)
