"""The virtual test bench: a plant, a hand, and experiments with the real compiled controller."""
