"""What the model refuses."""


class ChipFault(Exception):
    """The firmware did what the real chip would ignore, answer wrongly or never recover from."""

    def __init__(self, address: int, register: str, reason: str) -> None:
        super().__init__(f"{register} at {address:#010x}: {reason}")
        self.address = address
        self.register = register
        self.reason = reason
