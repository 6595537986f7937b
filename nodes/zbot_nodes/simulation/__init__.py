"""Programs of Gazebo's packages, answered by zbot's simulator."""
