"""A map of pose quality: ours against vectorised NumPy and a loop over quadprog and SciPy."""
