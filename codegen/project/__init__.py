"""A folder of the user's own around one machine: its file, its C, applications, tests."""
