"""Templates of the files of a new package. Their lines have the order of `ros2 pkg create`.

Tutorials tell their readers which lines to change. So these lines are the same as in ROS 2.
"""

from __future__ import annotations

from string import Template

MANIFEST = Template("""\
<?xml version="1.0"?>
<?xml-model href="http://download.ros.org/schema/package_format$format.xsd" \
schematypens="http://www.w3.org/2001/XMLSchema"?>
<package format="$format">
  <name>$name</name>
  <version>0.0.0</version>
  <description>$description</description>
  <maintainer email="$email">$maintainer</maintainer>
  <license>$license</license>
$dependencies
  <export>
    <build_type>$build_type</build_type>
  </export>
</package>
""")

SETUP_PY = Template("""\
from setuptools import find_packages, setup

package_name = '$name'

setup(
    name=package_name,
    version='0.0.0',
    packages=find_packages(exclude=['test']),
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/' + package_name]),
        ('share/' + package_name, ['package.xml']),
    ],
    install_requires=['setuptools'],
    zip_safe=True,
    maintainer=$maintainer,
    maintainer_email=$email,
    description=$description,
    license=$license,
    extras_require={
        'test': ['pytest'],
    },
    entry_points={
        'console_scripts': [$scripts
        ],
    },
)
""")

SETUP_CFG = Template("""\
[develop]
script_dir=$$base/lib/$name
[install]
install_scripts=$$base/lib/$name
""")

NODE = Template("""\
def main():
    print('Hi from $name.')


if __name__ == '__main__':
    main()
""")

#: Test that runs a linter of ROS 2. The test is skipped if the linter is not installed.
LINT_TEST = Template("""\
import pytest

linter = pytest.importorskip('ament_$linter.main')

$before
@pytest.mark.$linter
@pytest.mark.linter
def test_$linter():
    assert linter.main(argv=['.', 'test']) == 0
""")

CMAKE_LISTS = Template("""\
cmake_minimum_required(VERSION 3.8)
project($name)

if(CMAKE_COMPILER_IS_GNUCXX OR CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  add_compile_options(-Wall -Wextra -Wpedantic)
endif()

# packages that this package needs
$packages
$targets
if(BUILD_TESTING)
  find_package(ament_lint_auto REQUIRED)
  ament_lint_auto_find_test_dependencies()
endif()

ament_package()
""")

PLAIN_CMAKE_LISTS = Template("""\
cmake_minimum_required(VERSION 3.8)
project($name)

# packages that this package needs
$packages
$targets
install(FILES package.xml DESTINATION share/$${PROJECT_NAME})
""")

CMAKE_LIBRARY = Template("""
add_library($target src/$target.cpp)
target_include_directories($target PUBLIC
  $$<BUILD_INTERFACE:$${CMAKE_CURRENT_SOURCE_DIR}/include>
  $$<INSTALL_INTERFACE:include/$${PROJECT_NAME}>)
install(DIRECTORY include/ DESTINATION include/$${PROJECT_NAME})
install(TARGETS $target ARCHIVE DESTINATION lib LIBRARY DESTINATION lib RUNTIME DESTINATION bin)
""")

CMAKE_NODE = Template("""
add_executable($target src/$target.cpp)
target_include_directories($target PUBLIC
  $$<BUILD_INTERFACE:$${CMAKE_CURRENT_SOURCE_DIR}/include>
  $$<INSTALL_INTERFACE:include/$${PROJECT_NAME}>)
install(TARGETS $target DESTINATION lib/$${PROJECT_NAME})
""")

CPP_NODE = Template("""\
#include <cstdio>

int main()
{
  std::printf("Hi from $name.\\n");
  return 0;
}
""")

CPP_HEADER = Template("""\
#ifndef ${guard}_HPP_
#define ${guard}_HPP_

namespace $name
{

class $class_name
{
public:
  $class_name();
};

}  // namespace $name

#endif  // ${guard}_HPP_
""")

CPP_LIBRARY = Template("""\
#include "$name/$target.hpp"

namespace $name
{

$class_name::$class_name() = default;

}  // namespace $name
""")
