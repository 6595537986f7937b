# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import builtin_interfaces.msg
import geometry_msgs.msg
import sensor_msgs.msg
import std_msgs.msg
import visualization_msgs.msg
from zbot.interfaces import Action, Message, Service

class ImageMarker(Message):
    """visualization_msgs/msg/ImageMarker

    # Something to draw on top of an image, in pixels.

    # Shapes
    int32 CIRCLE=0
    int32 LINE_STRIP=1
    int32 LINE_LIST=2
    int32 POLYGON=3
    int32 POINTS=4

    # Actions
    int32 ADD=0
    int32 REMOVE=1

    std_msgs/Header header
    # Group of the marker; group and id together name it.
    string ns
    # Number within the group.
    int32 id
    # One of the shapes.
    int32 type
    # One of the actions.
    int32 action
    # Where, in pixels; z is not used.
    geometry_msgs/Point position
    # How big, in pixels: of a CIRCLE the diameter.
    float32 scale
    # Colour of the line.
    std_msgs/ColorRGBA outline_color
    # 1 to fill the shape.
    uint8 filled
    # Colour of the inside.
    std_msgs/ColorRGBA fill_color
    # How long to show it; 0 for ever.
    builtin_interfaces/Duration lifetime

    # Corners of shapes that have several, in pixels.
    geometry_msgs/Point[] points
    # A colour for each of them; may be empty.
    std_msgs/ColorRGBA[] outline_colors
    """
    CIRCLE: Final = 0
    LINE_STRIP: Final = 1
    LINE_LIST: Final = 2
    POLYGON: Final = 3
    POINTS: Final = 4
    ADD: Final = 0
    REMOVE: Final = 1
    def __init__(self, *, header: std_msgs.msg.Header = ..., ns: str = ..., id: int = ..., type: int = ..., action: int = ..., position: geometry_msgs.msg.Point = ..., scale: float = ..., outline_color: std_msgs.msg.ColorRGBA = ..., filled: int = ..., fill_color: std_msgs.msg.ColorRGBA = ..., lifetime: builtin_interfaces.msg.Duration = ..., points: Collection[geometry_msgs.msg.Point] = ..., outline_colors: Collection[std_msgs.msg.ColorRGBA] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    ns: str
    id: int
    type: int
    action: int
    position: geometry_msgs.msg.Point
    scale: float
    outline_color: std_msgs.msg.ColorRGBA
    filled: int
    fill_color: std_msgs.msg.ColorRGBA
    lifetime: builtin_interfaces.msg.Duration
    @property
    def points(self) -> list[geometry_msgs.msg.Point]: ...
    @points.setter
    def points(self, value: Collection[geometry_msgs.msg.Point]) -> None: ...
    @property
    def outline_colors(self) -> list[std_msgs.msg.ColorRGBA]: ...
    @outline_colors.setter
    def outline_colors(self, value: Collection[std_msgs.msg.ColorRGBA]) -> None: ...

class InteractiveMarker(Message):
    """visualization_msgs/msg/InteractiveMarker

    # Something in a 3D view that the user can drag, turn or click.

    # Its frame. A stamp of 0 keeps it attached to the frame as that moves; feedback then uses the same frame.
    std_msgs/Header header

    # Where it begins; turning happens about this point.
    geometry_msgs/Pose pose

    # Its name, different from all others on this topic.
    string name

    # A few words to show beside it.
    string description

    # Size of the usual controls in m.
    float32 scale

    # Menu that a right click opens.
    MenuEntry[] menu_entries

    # What the user can do with it.
    InteractiveMarkerControl[] controls
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., pose: geometry_msgs.msg.Pose = ..., name: str = ..., description: str = ..., scale: float = ..., menu_entries: Collection[visualization_msgs.msg.MenuEntry] = ..., controls: Collection[visualization_msgs.msg.InteractiveMarkerControl] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    pose: geometry_msgs.msg.Pose
    name: str
    description: str
    scale: float
    @property
    def menu_entries(self) -> list[visualization_msgs.msg.MenuEntry]: ...
    @menu_entries.setter
    def menu_entries(self, value: Collection[visualization_msgs.msg.MenuEntry]) -> None: ...
    @property
    def controls(self) -> list[visualization_msgs.msg.InteractiveMarkerControl]: ...
    @controls.setter
    def controls(self, value: Collection[visualization_msgs.msg.InteractiveMarkerControl]) -> None: ...

class InteractiveMarkerControl(Message):
    """visualization_msgs/msg/InteractiveMarkerControl

    # One handle of an InteractiveMarker.

    # Its name, different from the marker's other handles; feedback mentions it.
    string name

    # Direction of the handle relative to the marker: motions refer to its x axis.
    geometry_msgs/Quaternion orientation

    # INHERIT: turns with the marker. FIXED: keeps its direction. VIEW_FACING: always faces the viewer.
    uint8 INHERIT = 0
    uint8 FIXED = 1
    uint8 VIEW_FACING = 2

    uint8 orientation_mode

    # What it does when used
    # NONE: nothing, only looks.        MENU: opens the menu.
    # BUTTON: reports clicks.           MOVE_AXIS: slides along x.
    # MOVE_PLANE: slides in y and z.    ROTATE_AXIS: turns about x.
    # MOVE_ROTATE: slides in y and z and turns about x.
    uint8 NONE = 0
    uint8 MENU = 1
    uint8 BUTTON = 2
    uint8 MOVE_AXIS = 3
    uint8 MOVE_PLANE = 4
    uint8 ROTATE_AXIS = 5
    uint8 MOVE_ROTATE = 6
    # Free motion in space, free turning, and both; for 3D mice, or a mouse with SHIFT or CTRL held.
    uint8 MOVE_3D = 7
    uint8 ROTATE_3D = 8
    uint8 MOVE_ROTATE_3D = 9

    uint8 interaction_mode

    # True to show its markers even while nothing can be dragged.
    bool always_visible

    # How it looks; empty for arrows and rings chosen by the viewer.
    # A marker without frame is placed relative to the InteractiveMarker.
    Marker[] markers

    # With VIEW_FACING: true if its markers shall not turn to the viewer.
    bool independent_marker_orientation

    # A few words on what it does; may be empty.
    string description
    """
    INHERIT: Final = 0
    FIXED: Final = 1
    VIEW_FACING: Final = 2
    NONE: Final = 0
    MENU: Final = 1
    BUTTON: Final = 2
    MOVE_AXIS: Final = 3
    MOVE_PLANE: Final = 4
    ROTATE_AXIS: Final = 5
    MOVE_ROTATE: Final = 6
    MOVE_3D: Final = 7
    ROTATE_3D: Final = 8
    MOVE_ROTATE_3D: Final = 9
    def __init__(self, *, name: str = ..., orientation: geometry_msgs.msg.Quaternion = ..., orientation_mode: int = ..., interaction_mode: int = ..., always_visible: bool = ..., markers: Collection[visualization_msgs.msg.Marker] = ..., independent_marker_orientation: bool = ..., description: str = ..., check_fields: bool = ...) -> None: ...
    name: str
    orientation: geometry_msgs.msg.Quaternion
    orientation_mode: int
    interaction_mode: int
    always_visible: bool
    @property
    def markers(self) -> list[visualization_msgs.msg.Marker]: ...
    @markers.setter
    def markers(self, value: Collection[visualization_msgs.msg.Marker]) -> None: ...
    independent_marker_orientation: bool
    description: str

class InteractiveMarkerFeedback(Message):
    """visualization_msgs/msg/InteractiveMarkerFeedback

    # Tells what the user did with an InteractiveMarker.

    # When, and the frame of the pose.
    std_msgs/Header header

    # Which viewer reports.
    string client_id

    # Which marker and which handle of it.
    string marker_name
    string control_name

    # KEEP_ALIVE: still dragging. POSE_UPDATE: moved.
    # MENU_SELECT: menu entry chosen. BUTTON_CLICK: handle clicked.
    uint8 KEEP_ALIVE = 0
    uint8 POSE_UPDATE = 1
    uint8 MENU_SELECT = 2
    uint8 BUTTON_CLICK = 3

    uint8 MOUSE_DOWN = 4
    uint8 MOUSE_UP = 5

    uint8 event_type

    # Where the marker is now; always filled in.
    geometry_msgs/Pose pose

    # Which entry, for MENU_SELECT.
    uint32 menu_entry_id

    # Where on the handle the mouse was, for clicks and mouse buttons; only if mouse_point_valid.
    geometry_msgs/Point mouse_point
    bool mouse_point_valid
    """
    KEEP_ALIVE: Final = 0
    POSE_UPDATE: Final = 1
    MENU_SELECT: Final = 2
    BUTTON_CLICK: Final = 3
    MOUSE_DOWN: Final = 4
    MOUSE_UP: Final = 5
    def __init__(self, *, header: std_msgs.msg.Header = ..., client_id: str = ..., marker_name: str = ..., control_name: str = ..., event_type: int = ..., pose: geometry_msgs.msg.Pose = ..., menu_entry_id: int = ..., mouse_point: geometry_msgs.msg.Point = ..., mouse_point_valid: bool = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    client_id: str
    marker_name: str
    control_name: str
    event_type: int
    pose: geometry_msgs.msg.Pose
    menu_entry_id: int
    mouse_point: geometry_msgs.msg.Point
    mouse_point_valid: bool

class InteractiveMarkerInit(Message):
    """visualization_msgs/msg/InteractiveMarkerInit

    # All markers of a server, for a viewer that has just come.

    # Name of the server, different from all others on this topic.
    string server_id

    # Number of the last update contained in here, so that a viewer notices what it missed.
    uint64 seq_num

    # The markers.
    InteractiveMarker[] markers
    """
    def __init__(self, *, server_id: str = ..., seq_num: int = ..., markers: Collection[visualization_msgs.msg.InteractiveMarker] = ..., check_fields: bool = ...) -> None: ...
    server_id: str
    seq_num: int
    @property
    def markers(self) -> list[visualization_msgs.msg.InteractiveMarker]: ...
    @markers.setter
    def markers(self, value: Collection[visualization_msgs.msg.InteractiveMarker]) -> None: ...

class InteractiveMarkerPose(Message):
    """visualization_msgs/msg/InteractiveMarkerPose

    # New place of an InteractiveMarker.

    # Its frame.
    std_msgs/Header header

    # The place in that frame.
    geometry_msgs/Pose pose

    # Which marker.
    string name
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., pose: geometry_msgs.msg.Pose = ..., name: str = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    pose: geometry_msgs.msg.Pose
    name: str

class InteractiveMarkerUpdate(Message):
    """visualization_msgs/msg/InteractiveMarkerUpdate

    # What changed among the markers of a server.

    # Name of the server, different from all others on this topic.
    string server_id

    # Counts updates, so that a viewer notices a gap.
    uint64 seq_num

    # UPDATE: something changed, seq_num went up by one.
    # KEEP_ALIVE: nothing changed, the lists below are empty and seq_num stays.
    uint8 KEEP_ALIVE = 0
    uint8 UPDATE = 1

    uint8 type

    # The lists may be worked through in any order, so a marker belongs in one of them only.

    # New or replaced
    InteractiveMarker[] markers

    # Moved
    InteractiveMarkerPose[] poses

    # Removed, by name
    string[] erases
    """
    KEEP_ALIVE: Final = 0
    UPDATE: Final = 1
    def __init__(self, *, server_id: str = ..., seq_num: int = ..., type: int = ..., markers: Collection[visualization_msgs.msg.InteractiveMarker] = ..., poses: Collection[visualization_msgs.msg.InteractiveMarkerPose] = ..., erases: Collection[str] = ..., check_fields: bool = ...) -> None: ...
    server_id: str
    seq_num: int
    type: int
    @property
    def markers(self) -> list[visualization_msgs.msg.InteractiveMarker]: ...
    @markers.setter
    def markers(self, value: Collection[visualization_msgs.msg.InteractiveMarker]) -> None: ...
    @property
    def poses(self) -> list[visualization_msgs.msg.InteractiveMarkerPose]: ...
    @poses.setter
    def poses(self, value: Collection[visualization_msgs.msg.InteractiveMarkerPose]) -> None: ...
    @property
    def erases(self) -> list[str]: ...
    @erases.setter
    def erases(self, value: Collection[str]) -> None: ...

class Marker(Message):
    """visualization_msgs/msg/Marker

    # Something to draw in a 3D view such as RViz.

    # Shapes
    int32 ARROW=0
    int32 CUBE=1
    int32 SPHERE=2
    int32 CYLINDER=3
    int32 LINE_STRIP=4
    int32 LINE_LIST=5
    int32 CUBE_LIST=6
    int32 SPHERE_LIST=7
    int32 POINTS=8
    int32 TEXT_VIEW_FACING=9
    int32 MESH_RESOURCE=10
    int32 TRIANGLE_LIST=11
    int32 ARROW_STRIP=12

    # Actions
    int32 ADD=0
    int32 MODIFY=0
    int32 DELETE=2
    int32 DELETEALL=3

    # Time and frame of everything below.
    std_msgs/Header header
    # Group of the marker; group and id together name it.
    string ns
    # Number within the group; sending it again replaces the marker.
    int32 id
    # One of the shapes.
    int32 type
    # One of the actions. DELETEALL removes the whole group, or everything if ns is empty.
    int32 action
    # Where, in the frame of the header.
    geometry_msgs/Pose pose
    # How big along x, y and z, in m.
    geometry_msgs/Vector3 scale
    # Colour; a must be above 0 for anything to be seen.
    std_msgs/ColorRGBA color
    # How long to show it; 0 for ever.
    builtin_interfaces/Duration lifetime
    # True to keep it attached to its frame as that moves.
    bool frame_locked

    # Corners or places of shapes that have several: lines, lists, points, strips.
    geometry_msgs/Point[] points
    # A colour for each of points; may be empty.
    std_msgs/ColorRGBA[] colors

    # Picture to put on the surface: the address of a file, or 'embedded://NAME' for the one in texture.
    string texture_resource
    # The picture, packed.
    sensor_msgs/CompressedImage texture
    # Which spot of the picture belongs to each corner.
    UVCoordinate[] uv_coordinates

    # Words to show, for TEXT_VIEW_FACING.
    string text

    # For MESH_RESOURCE: the address of a 3D model, or 'embedded://NAME' for the one in mesh_file.
    string mesh_resource
    MeshFile mesh_file
    bool mesh_use_embedded_materials # true to take the colours from the model
    """
    ARROW: Final = 0
    CUBE: Final = 1
    SPHERE: Final = 2
    CYLINDER: Final = 3
    LINE_STRIP: Final = 4
    LINE_LIST: Final = 5
    CUBE_LIST: Final = 6
    SPHERE_LIST: Final = 7
    POINTS: Final = 8
    TEXT_VIEW_FACING: Final = 9
    MESH_RESOURCE: Final = 10
    TRIANGLE_LIST: Final = 11
    ARROW_STRIP: Final = 12
    ADD: Final = 0
    MODIFY: Final = 0
    DELETE: Final = 2
    DELETEALL: Final = 3
    def __init__(self, *, header: std_msgs.msg.Header = ..., ns: str = ..., id: int = ..., type: int = ..., action: int = ..., pose: geometry_msgs.msg.Pose = ..., scale: geometry_msgs.msg.Vector3 = ..., color: std_msgs.msg.ColorRGBA = ..., lifetime: builtin_interfaces.msg.Duration = ..., frame_locked: bool = ..., points: Collection[geometry_msgs.msg.Point] = ..., colors: Collection[std_msgs.msg.ColorRGBA] = ..., texture_resource: str = ..., texture: sensor_msgs.msg.CompressedImage = ..., uv_coordinates: Collection[visualization_msgs.msg.UVCoordinate] = ..., text: str = ..., mesh_resource: str = ..., mesh_file: visualization_msgs.msg.MeshFile = ..., mesh_use_embedded_materials: bool = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    ns: str
    id: int
    type: int
    action: int
    pose: geometry_msgs.msg.Pose
    scale: geometry_msgs.msg.Vector3
    color: std_msgs.msg.ColorRGBA
    lifetime: builtin_interfaces.msg.Duration
    frame_locked: bool
    @property
    def points(self) -> list[geometry_msgs.msg.Point]: ...
    @points.setter
    def points(self, value: Collection[geometry_msgs.msg.Point]) -> None: ...
    @property
    def colors(self) -> list[std_msgs.msg.ColorRGBA]: ...
    @colors.setter
    def colors(self, value: Collection[std_msgs.msg.ColorRGBA]) -> None: ...
    texture_resource: str
    texture: sensor_msgs.msg.CompressedImage
    @property
    def uv_coordinates(self) -> list[visualization_msgs.msg.UVCoordinate]: ...
    @uv_coordinates.setter
    def uv_coordinates(self, value: Collection[visualization_msgs.msg.UVCoordinate]) -> None: ...
    text: str
    mesh_resource: str
    mesh_file: visualization_msgs.msg.MeshFile
    mesh_use_embedded_materials: bool

class MarkerArray(Message):
    """visualization_msgs/msg/MarkerArray

    # Several markers sent together.

    Marker[] markers
    """
    def __init__(self, *, markers: Collection[visualization_msgs.msg.Marker] = ..., check_fields: bool = ...) -> None: ...
    @property
    def markers(self) -> list[visualization_msgs.msg.Marker]: ...
    @markers.setter
    def markers(self, value: Collection[visualization_msgs.msg.Marker]) -> None: ...

class MenuEntry(Message):
    """visualization_msgs/msg/MenuEntry

    # One entry of an InteractiveMarker's menu.
    #
    # The entries form a tree although they come in a flat list: parent_id names the entry above, 0 the top.
    # A parent comes before its children; otherwise the order is that of the list.

    # Number of the entry, above 0 and different from the others.
    uint32 id

    # Number of the entry above it, or 0.
    uint32 parent_id

    # Text to show.
    string title

    # Arguments for command_type.
    string command

    # What a click does: FEEDBACK reports it, ROSRUN and ROSLAUNCH start the program named in command.
    uint8 FEEDBACK=0
    uint8 ROSRUN=1
    uint8 ROSLAUNCH=2
    uint8 command_type
    """
    FEEDBACK: Final = 0
    ROSRUN: Final = 1
    ROSLAUNCH: Final = 2
    def __init__(self, *, id: int = ..., parent_id: int = ..., title: str = ..., command: str = ..., command_type: int = ..., check_fields: bool = ...) -> None: ...
    id: int
    parent_id: int
    title: str
    command: str
    command_type: int

class MeshFile(Message):
    """visualization_msgs/msg/MeshFile

    # A 3D model, sent as a file.

    # Its name; the ending tells the format.
    string filename

    # The bytes of the file.
    uint8[] data
    """
    def __init__(self, *, filename: str = ..., data: Collection[int] = ..., check_fields: bool = ...) -> None: ...
    filename: str
    @property
    def data(self) -> array[int]: ...
    @data.setter
    def data(self, value: Collection[int]) -> None: ...

class UVCoordinate(Message):
    """visualization_msgs/msg/UVCoordinate

    # A spot in a picture, as shares of its width and height from 0 to 1.

    float32 u
    float32 v
    """
    def __init__(self, *, u: float = ..., v: float = ..., check_fields: bool = ...) -> None: ...
    u: float
    v: float
