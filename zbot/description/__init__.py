"""Reader of robot descriptions in URDF."""
