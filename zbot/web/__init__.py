"""The live page: what a domain's nodes do, in a browser on this machine."""
