"""Nav2's `nav2_simple_commander`."""
