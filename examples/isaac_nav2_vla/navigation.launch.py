"""Nav2 in an exported apartment: maps, keep-out filter, localisation, planner, controller.

    ros2 launch ./navigation.launch.py maps:=/path/to/guided-12/nav2

Written for ROS 2 Jazzy and not run with Isaac Sim yet. `maps` is the folder that `apartgen export --format nav2` wrote.
`localise:=false` takes the simulator's pose as known, as `apartgen bench embodied` does, in place of AMCL.
"""

from pathlib import Path

MAPS = {"map_server": "map.yaml", "lidar_map_server": "lidar.yaml", "keepout_filter_mask_server": "keepout.yaml"}
"""The map that each server gives out: for planning, for localisation, and the keep-out filter's mask."""
SERVERS = {
    "keepout_costmap_filter_info_server": ("nav2_map_server", "costmap_filter_info_server"),
    "planner_server": ("nav2_planner", "planner_server"),
    "controller_server": ("nav2_controller", "controller_server"),
    "behavior_server": ("nav2_behaviors", "behavior_server"),
    "velocity_smoother": ("nav2_velocity_smoother", "velocity_smoother"),
    "bt_navigator": ("nav2_bt_navigator", "bt_navigator"),
}
"""Package and program of the others, in the order in which they start."""
RENAMED = {
    "controller_server": [("cmd_vel", "cmd_vel_nav")],
    "behavior_server": [("cmd_vel", "cmd_vel_nav")],
    "velocity_smoother": [("cmd_vel", "cmd_vel_nav"), ("cmd_vel_smoothed", "cmd_vel")],
}
PARAMETERS = str(Path(__file__).with_name("nav2_params.yaml"))


def generate_launch_description():
    """What `ros2 launch` asks for."""
    from launch import LaunchDescription
    from launch.actions import DeclareLaunchArgument
    from launch.conditions import IfCondition, UnlessCondition
    from launch.substitutions import LaunchConfiguration, PathJoinSubstitution
    from launch_ros.actions import Node

    maps, localise = LaunchConfiguration("maps"), LaunchConfiguration("localise")

    def server(name, package, program, *more, **options):
        return Node(package=package, executable=program, name=name, output="screen", parameters=[PARAMETERS, *more],
                    remappings=RENAMED.get(name, []), **options)

    def manager(name, names, **options):
        about = {"use_sim_time": True, "autostart": True, "node_names": names}
        return Node(package="nav2_lifecycle_manager", executable="lifecycle_manager", name=name, output="screen",
                    parameters=[about], **options)

    exact = ["--frame-id", "map", "--child-frame-id", "odom"]
    return LaunchDescription([
        DeclareLaunchArgument("maps", description="folder with map.yaml, lidar.yaml and keepout.yaml"),
        DeclareLaunchArgument("localise", default_value="true", description="by AMCL; false: the pose is known"),
        *(server(name, "nav2_map_server", "map_server", {"yaml_filename": PathJoinSubstitution([maps, file])})
          for name, file in MAPS.items()),
        server("amcl", "nav2_amcl", "amcl", condition=IfCondition(localise)),
        Node(package="tf2_ros", executable="static_transform_publisher", arguments=exact,
             parameters=[{"use_sim_time": True}], condition=UnlessCondition(localise)),
        *(server(name, *program) for name, program in SERVERS.items()),
        manager("lifecycle_manager_maps", list(MAPS)),
        manager("lifecycle_manager_localization", ["amcl"], condition=IfCondition(localise)),
        manager("lifecycle_manager_navigation", list(SERVERS)),
    ])
