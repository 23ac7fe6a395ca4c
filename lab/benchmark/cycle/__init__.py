"""One control cycle of the master, as every port runs it, but with its buses in memory."""
