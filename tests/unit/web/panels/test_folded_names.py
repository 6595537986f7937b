from __future__ import annotations

from zbot.web.panels.topics.folded_names import FoldedRow, folded

NAMES = ["/chatter", "/robot1/arm/angle", "/robot1/arm/force", "/robot1/scan", "/robot2/scan"]


def test_a_namespace_with_several_names_is_one_row() -> None:
    rows = folded(NAMES, opened=())
    assert [row.name for row in rows] == ["/chatter", "/robot1/", "/robot2/scan"]
    assert rows[1].names == ("/robot1/arm/angle", "/robot1/arm/force", "/robot1/scan")


def test_an_open_namespace_shows_its_names_and_its_own_namespaces() -> None:
    assert folded(NAMES, opened={"/robot1/"})[2:] == [
        FoldedRow("/robot1/arm/", 1, ("/robot1/arm/angle", "/robot1/arm/force")),
        FoldedRow("/robot1/scan", 1),
        FoldedRow("/robot2/scan", 0),
    ]


def test_a_namespace_inside_a_closed_one_stays_closed() -> None:
    assert folded(NAMES, opened={"/robot1/arm/"}) == folded(NAMES, opened=())


def test_namespaces_with_one_child_are_one_row() -> None:
    names = ["/chatter", "/house/robot/left", "/house/robot/right"]
    assert folded(names, ())[1].name == "/house/robot/"


def test_a_namespace_of_all_names_is_no_row() -> None:
    assert [row.name for row in folded(["/r/a", "/r/b/c", "/r/b/d"], ())] == ["/r/a", "/r/b/"]


def test_no_names_are_no_rows() -> None:
    assert folded([], ()) == []
