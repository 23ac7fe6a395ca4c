"""Is a machine any good: maps, numbers and a report of one, and two machines side by side."""
