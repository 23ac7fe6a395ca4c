"""Arguments of a machine's C with the bits that it gives for them, the same on every processor."""
