"""The complete runtime on an emulated Cortex-M, held against the same runtime on this computer."""
