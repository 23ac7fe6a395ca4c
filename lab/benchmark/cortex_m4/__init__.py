"""Instructions per call on a Cortex-M4F in single precision: ours against other generators' C."""
