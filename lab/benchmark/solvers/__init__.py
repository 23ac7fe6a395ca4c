"""One file a solver of the tension problem, all of the same form."""
