"""Reader of SDF, the format of Gazebo's worlds and models."""
