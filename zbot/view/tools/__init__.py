"""Tools of the view: what a click in the scene does. They have the names that they have in rviz."""
