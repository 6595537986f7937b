"""The `zbot` command."""
