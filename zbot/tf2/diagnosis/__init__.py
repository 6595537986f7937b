"""Diagnosis of transforms: what is wrong with the frames, and why a transform is missing.

diagnosis = Diagnosis()
monitor = TransformMonitor(diagnosis, node)
problem = diagnosis.why("map", "laser")
if problem is not None:
    print(problem.text, problem.advice)
"""

from zbot.tf2.diagnosis.diagnosis import Diagnosis as Diagnosis
from zbot.tf2.diagnosis.forest import Branch as Branch
from zbot.tf2.diagnosis.forest import Forest as Forest
from zbot.tf2.diagnosis.link import Link as Link
from zbot.tf2.diagnosis.monitor import TransformMonitor as TransformMonitor
from zbot.tf2.diagnosis.problem import Cause as Cause
from zbot.tf2.diagnosis.problem import Problem as Problem
