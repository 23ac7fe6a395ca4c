"""What a user can cause: the command line shows it as one message, anything else as a defect."""


class Refusal(Exception):
    """What was asked cannot be done; str() is the whole message, for the user to read."""
