"""The model of a machine, written once and symbolically; one file per topic."""
