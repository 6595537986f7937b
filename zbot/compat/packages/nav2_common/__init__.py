"""Nav2's `nav2_common`."""
