"""Classes of students, and hubs. Each machine's hub (a Zenoh router) dials one common hub."""
