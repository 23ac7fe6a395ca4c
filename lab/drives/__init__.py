"""Simulated drives: servo drives of any kind on a simulated CAN bus (CiA 301, CiA 402).

What a kind has of its own is in model/bus/drive_kinds.

objects.py    the object dictionary: what there is, its type, range and default
node.py       SDO server (python `canopen`) over that dictionary, with the drive's abort codes
pdo.py        process data: mapping rules, what is sent and taken at a SYNC
power.py      state machine of the power stage (CiA 402)
motion.py     what the motor does: torque, position, homing, ramps to standstill
errors.py     error codes, what a drive does about them
drive.py      one drive: all of the above, and NMT, heartbeats, emergencies
bus.py        drives on one bus, and what can go wrong on it
runner.py     real time: simulated buses behind python-can ones

Time is simulated time: nothing here reads a clock except the runner.
"""
