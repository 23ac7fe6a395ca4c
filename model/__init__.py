"""What a machine is: its file, its symbolic model, the independent reference and its workspace."""
