"""What would fail in a package: each module looks at one kind of file."""
