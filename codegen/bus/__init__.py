"""What is generated about buses and drives: the runtime's tables and a DBC a bus."""
