"""Mutants of the runtime: C with one small defect, which the tests have to notice."""
