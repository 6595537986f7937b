"""Marking of programs: a program drives a robot in a world, and the run meets goals or not.

`grammar.py` reads the goals, `goals.py` has their kinds, and `sight.py` says what they see. A
`trial.py` is one run of one program, `recording.py` writes its bag, and `submissions.py` finds the
programs in a folder.
"""
