"""Picture of a topic's last message: a camera image, or a laser scan seen from above."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from nicegui import ui

from zbot.observer.image_encoder import IMAGE_TYPES
from zbot.web.page.encoded_picture import newest_picture

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.observer.watch import Watch
    from zbot.web.page.panel import Section

_SCAN = "sensor_msgs/msg/LaserScan"
#: The types whose messages have a picture.
PICTURE_TYPES = (*IMAGE_TYPES, _SCAN)
_PICTURE_HZ = 15.0
#: The edge of the largest circle in the picture has about 1440 pixels. With more points, the
#: picture looks the same.
_MOST_RAYS = 1440


def add_picture(section: Section, watch: Watch) -> None:
    """Add a picture to the current element, if the topic's type is an image or a laser scan."""
    place = ui.element("div").classes("zb-picture")
    place.set_visibility(False)
    undo: Callable[[], None]

    def look() -> None:
        if watch.type_name is None:
            return
        undo()
        if watch.type_name in PICTURE_TYPES:
            place.set_visibility(True)
            with place:
                add = _add_scan if watch.type_name == _SCAN else _add_image
                add(section, watch)

    undo = section.live(look, 10.0)


def _add_image(section: Section, watch: Watch) -> None:
    picture = ui.element("img").props('alt="The last image"')
    said = ui.label().classes("zb-muted")
    shown: object = None

    def update() -> None:
        nonlocal shown
        newest = newest_picture(watch)
        if newest is None or newest is shown:
            return
        shown = newest
        said.set_text(newest.text)
        if newest.address:
            section.page.call("zbot.showPicture", picture.id, newest.address)

    section.live(update, _PICTURE_HZ)


def _add_scan(section: Section, watch: Watch) -> None:
    drawing = ui.element("div").classes("zb-scan")
    said = ui.label("x is up, y to the left").classes("zb-muted")
    shown: object = None

    def update() -> None:
        nonlocal shown
        message = watch.latest
        # The topic may have another type since the last look.
        if message is None or message is shown or watch.type_name != _SCAN:
            return
        shown = message
        points, reach = points_of(message)
        said.set_text(f"{len(message.ranges)} rays, x is up, rings every {ring(reach):g} m")
        section.page.call("zbot.showScan", drawing.id, points, reach, ring(reach))

    section.live(update, _PICTURE_HZ)


def points_of(scan: Any) -> tuple[list[float], float]:
    """Return the points of a scan, and the radius of the picture.

    Returns:
        The coordinates [x (forward), y (left), x, y, ...] in m, and the distance of the farthest
        point, but at least 1 m.
    """
    count = len(scan.ranges)
    every = -(-count // _MOST_RAYS) or 1
    points: list[float] = []
    farthest = 1.0
    for index in range(0, count, every):
        distance = float(scan.ranges[index])
        # Values outside of the sensor's range are left out. Infinity and NaN are left out too.
        if not scan.range_min <= distance <= scan.range_max or math.isinf(distance):
            continue
        angle = scan.angle_min + index * scan.angle_increment
        if not math.isfinite(angle):
            continue
        points += (round(distance * math.cos(angle), 3), round(distance * math.sin(angle), 3))
        farthest = max(farthest, distance)
    return points, round(farthest, 3)


def ring(reach: float) -> float:
    """Return the distance between rings in metres, which is 1, 2 or 5 times a power of ten."""
    power = 10.0 ** math.floor(math.log10(reach / 2))
    return next(power * digit for digit in (1.0, 2.0, 5.0, 10.0) if power * digit * 5 >= reach)
