"""What a machine can do where: feasible wrenches, forces, tensions and motors, over whole batches.

The functions work on plain arrays: structure matrices S (..., d, n), one for each pose, and tension
bounds [N]; `structures` takes S from a machine. Rows of S that are moments are divided by the
machine's lever, so that every row of a wrench is in newtons: W = [F; M / lever].
"""
