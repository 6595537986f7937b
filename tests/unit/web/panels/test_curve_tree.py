from __future__ import annotations

from zbot.web.panels.plot.curve_tree import curve_tree


def test_fields_are_below_their_topic_and_their_message() -> None:
    found = curve_tree({"/imu": ["rate", "linear.x", "linear.y", "covariance[0]"], "/chatter": []})
    linear = {
        "id": "/imu/linear",
        "label": "linear",
        "children": [
            {"id": "/imu.linear.x", "label": "x"},
            {"id": "/imu.linear.y", "label": "y"},
        ],
    }
    covariance = {
        "id": "/imu/covariance",
        "label": "covariance",
        "children": [{"id": "/imu.covariance[0]", "label": "[0]"}],
    }
    rate = {"id": "/imu.rate", "label": "rate"}
    imu = {"id": "/imu", "label": "/imu", "children": [rate, linear, covariance]}
    assert found == [imu, {"id": "/chatter", "label": "/chatter"}]
