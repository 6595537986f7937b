import rclpy
from rclpy.logging import LoggingSeverity, get_logger, set_logger_level

rclpy.init()
node = rclpy.create_node('talkative')
set_logger_level('talkative', LoggingSeverity.DEBUG)
logger = node.get_logger()
logger.debug('deep inside')
logger.info('information')
logger.warning('careful')
logger.warn('old name')
logger.error('wrong')
logger.fatal('over')
for i in range(3):
    logger.info('only once', once=True)
    logger.info(f'not the first {i}', skip_first=True)
get_logger('elsewhere').info('without a node')
logger.get_child('part').info('a child')
rclpy.shutdown()
