"""A long run of the whole machine in lockstep, twice: no setpoint may be lost, doubled or late, and
both runs must be the same to the bit. `make soak` runs it.
"""
