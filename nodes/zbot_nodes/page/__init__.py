"""Names of programs of rqt, which open a panel of the page."""
