"""Classes of students, and hubs. Each machine's hub (a Zenoh router) connects to one common hub."""
