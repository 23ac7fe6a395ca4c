"""Symbolic model -> C: lower, simplify, arrange, print."""
