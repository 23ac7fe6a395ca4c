"""`python -m turnbuckle` is the command `turnbuckle`."""

from turnbuckle.command_line import main

main()
