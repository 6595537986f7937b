"""Motion of the robot on real physics: it has mass, its wheels push it, and walls stop it."""

from __future__ import annotations

from zbot.process.signals import ending_process
from zbot.simulation.engine import STEP_S, engine
from zbot.tf2.rigid import heading
from zbot_nodes.robot.pose import Pose
from zbot_nodes.robot.state import PERIOD_S, WHEEL_DISTANCE_M, WHEEL_RADIUS_M, State

_WHEEL = """
<link name="{name}">
  <collision>
    <origin rpy="1.570796 0 0"/>
    <geometry><cylinder radius="{radius}" length="0.03"/></geometry>
  </collision>
  <inertial>
    <mass value="0.1"/>
    <inertia ixx="0.00007" iyy="0.000125" izz="0.00007" ixy="0" ixz="0" iyz="0"/>
  </inertial>
</link>
<joint name="{name}_joint" type="continuous">
  <parent link="base_link"/>
  <child link="{name}"/>
  <origin xyz="0 {left} {radius}"/>
  <axis xyz="0 1 0"/>
</joint>
"""
_CASTER = """
<link name="{name}_caster">
  <collision><geometry><sphere radius="0.025"/></geometry></collision>
</link>
<joint name="{name}_caster_joint" type="fixed">
  <parent link="base_link"/>
  <child link="{name}_caster"/>
  <origin xyz="{ahead} 0 0.025"/>
</joint>
"""
_BODY = """
<robot name="robot">
  <link name="base_link">
    <collision>
      <origin xyz="0 0 0.12"/>
      <geometry><cylinder radius="0.2" length="0.1"/></geometry>
    </collision>
    <inertial>
      <origin xyz="0 0 0.06"/>
      <mass value="3"/>
      <inertia ixx="0.03" iyy="0.03" izz="0.05" ixy="0" ixz="0" iyz="0"/>
    </inertial>
  </link>
  {parts}
</robot>
"""


def _description() -> str:
    half = WHEEL_DISTANCE_M / 2
    wheels = (("wheel_left", half), ("wheel_right", -half))
    parts = [_WHEEL.format(name=name, left=left, radius=WHEEL_RADIUS_M) for name, left in wheels]
    casters = (("front", 0.13), ("rear", -0.13))
    parts += [_CASTER.format(name=name, ahead=ahead) for name, ahead in casters]
    return _BODY.format(parts="".join(parts))


class PhysicalMotion:
    """Motion in the room of the simulator.

    Raises:
        MissingPackageError: The extra `sim` is not installed.
    """

    def __init__(self) -> None:
        with ending_process():
            engine()
            # These modules need numpy, which the extra brings.
            from zbot.simulation.robots.equipment import Bumper  # noqa: PLC0415 - as above
            from zbot.simulation.robots.model import read_robot  # noqa: PLC0415 - see above
            from zbot.simulation.sensors.bumper import BumperSensor  # noqa: PLC0415 - as above
            from zbot.simulation.world import World  # noqa: PLC0415 - as above
            from zbot.simulation.worlds.catalog import room  # noqa: PLC0415 - as above
            from zbot.tf2.rigid import Rigid  # noqa: PLC0415 - as above

        self._world = World(room().spec())
        (self._robot,) = self._world.add([("robot", read_robot(_description()), Rigid())])
        self._bumper = BumperSensor(Bumper("base_link", "", 1.0), self._robot)

    def move(self, speed: float, turn: float) -> State:
        """Move for one period with the motors' strength."""
        self._robot.command = (speed, 0.0, turn)
        for _ in range(round(PERIOD_S / STEP_S)):
            self._world.step()
        linear, angular = self._robot.velocity
        _, (left, right), _ = self._robot.joint_states()
        touches = self._bumper.measure(self._world)
        is_blocked = any(touch.other != "floor" for touch in touches)
        # A body that rests on its wheels trembles by less than this.
        speed, turn = round(float(linear[0]), 3), round(float(angular[2]), 3)
        return State(self._pose(), speed + 0.0, turn + 0.0, (left, right), is_blocked)

    def _pose(self) -> Pose:
        x, y, _ = self._robot.pose.translation
        yaw = heading(self._robot.pose.rotation)
        return Pose(round(x, 4) + 0.0, round(y, 4) + 0.0, round(yaw, 4) + 0.0)
