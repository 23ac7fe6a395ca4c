"""Buses and drives: their tables in the machine file, and the proof that every frame is in time."""
