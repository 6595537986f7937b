"""ROS 2's `rosbag2_py`, which writes, reads, records and plays bags."""

from zbot.compat.rosbag2.sequential import (
    Info,
    LocalMessageDefinitionSource,
    MetadataIo,
    Reindexer,
    SequentialCompressionReader,
    SequentialCompressionWriter,
    SequentialReader,
    SequentialWriter,
    get_default_storage_id,
    get_registered_compressors,
    get_registered_readers,
    get_registered_serializers,
    get_registered_writers,
)
from zbot.compat.rosbag2.storage import (
    BagMetadata,
    CompressionMode,
    CompressionOptions,
    ConverterOptions,
    FileInformation,
    MessageDefinition,
    ReadOrder,
    ReadOrderSortBy,
    StorageFilter,
    StorageOptions,
    TopicInformation,
    TopicMetadata,
    compression_mode_from_string,
    compression_mode_to_string,
    convert_rclcpp_qos_to_rclpy_qos,
    to_rclcpp_qos_vector,
)
from zbot.compat.rosbag2.transport import Player, Recorder, bag_rewrite
from zbot.compat.rosbag2.transport_options import (
    MessageOrder,
    PlayOptions,
    RecordOptions,
    ServiceRequestsSource,
)
