#!/usr/bin/env python3
"""The layer check finds every kind of wrong arrow, and nothing in right ones."""
import pathlib
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / 'scripts'))
import check_layers  # noqa: E402


def faults(path, text):
    return check_layers.faults_of(pathlib.Path(path), text)


class LayerCheck(unittest.TestCase):
    def test_wrong_arrows_are_found(self):
        for path, text in [
            ('src/detection/a.cpp', '#include <ros/ros.h>'),
            ('src/detection/a.cpp', '#include <sensor_msgs/PointCloud2.h>'),
            ('src/detection/a.cpp', '#include <mixed_palletizing/BoxArray.h>'),
            ('src/detection/a.cpp', '#include <mixed_palletizing/packing/types.hpp>'),
            ('src/packing/a.cpp', '#include <mixed_palletizing/planning/next_pick.hpp>'),
            ('src/packing/a.cpp', '#include <pcl/point_types.h>'),
            ('include/mixed_palletizing/adapters/a.hpp', '#include <mixed_palletizing/nodes/a.hpp>'),
            ('src/adapters/a.cpp', '#include <mixed_palletizing/adapters/cell/a.hpp>'),
            ('src/adapters/captures/a.cpp', '#include <mixed_palletizing/adapters/cell/a.hpp>'),
            ('src/detection/a.cpp', '#include <mixed_palletizing/adapters/cell/a.hpp>'),
            ('src/detection/a.cpp', '#include "../packing/secret.hpp"'),
            ('src/packing/a.cpp', 'std::cout << 1;'),
            ('src/packing/a.cpp', 'std::exit(1);'),
            ('src/planning/a.cpp', 'auto t = std::chrono::system_clock::now();'),
            ('src/elsewhere/a.cpp', ''),
            ('src/a.cpp', ''),
        ]:
            self.assertEqual(len(faults(path, text)), 1, f'{path}: {text}')

    def test_right_arrows_pass(self):
        for path, text in [
            ('src/planning/a.cpp', '#include <mixed_palletizing/packing/types.hpp>'),
            ('src/detection/a.cpp', '#include <pcl/surface/convex_hull.h>\n#include <vector>\n#include "hull.hpp"'),
            ('src/adapters/rviz_panel/a.cpp', '#include <rviz/panel.h>\n#include <mixed_palletizing/adapters/names.hpp>'),
            ('src/nodes/a.cpp', '#include <ros/ros.h>\n#include <mixed_palletizing/adapters/names.hpp>'),
            ('src/packing/a.cpp', '// std::cout is not for a core room'),
        ]:
            self.assertEqual(faults(path, text), [])

    def test_the_package_is_clean(self):
        files, found = check_layers.check(ROOT)
        self.assertGreater(len(files), 10)
        self.assertEqual(found, [])


if __name__ == '__main__':
    unittest.main()
