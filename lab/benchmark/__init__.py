"""Our C against what one would use instead: same problems, one run. `make bench` runs it."""
