"""What a machine costs a Cortex-M4F: instructions of a cycle, flash, memory, stack."""
