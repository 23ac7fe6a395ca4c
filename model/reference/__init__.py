"""The model in plain NumPy, written from the papers: the oracle that judges the generated C.

It shares no code with what it judges. Every function takes the machine first, accepts any leading
batch axes, broadcasts them, and computes in the widest type it is given (double or long double).
A NaN in a result means: not defined there (the platform on a pulley, a pose outside the workspace).
"""
