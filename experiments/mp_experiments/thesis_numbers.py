"""Figures printed in the source thesis, chapter 4.1, beside the tables they stand in."""

# Table 4.1: y-axis and k-axis [deg]; 7 of 50 clouds without marker.
BASE_FRAME = {'found': 43, 'views': 50, 'tilt_mean': 0.00, 'yaw_mean': 0.058, 'tilt_std': 0.00, 'yaw_std': 0.00}
# 4.1.3: clouds of two boxes in which all boxes were found.
CLUSTERING = {'clouds': 22, 'all_found': 20}
# Table 4.2 [mm]: mean, RMS, standard deviation.
HEIGHT = {'Zivid': (0.66, 2.73, 3.42), 'simulator': (1.00, 1.01, 0.17)}
# Table 4.3 [mm], base frame: x, z, Euclidean distance.
POSITION_BASE = {'mean': (-0.16, -0.62, 3.10), 'rms': (2.81, 1.96, 3.58), 'std': (2.80, 1.86, 1.78)}
# Table 4.4 [mm], camera frame: x, y, z, Euclidean distance.
POSITION_CAMERA = {'mean': (-0.00, 0.87, 0.65, 1.53), 'rms': (0.75, 1.10, 0.75, 1.63), 'std': (0.93, 0.68, 0.39, 0.55)}
# 4.1.5, figure 4.13 [mm]: distance of the centre under occlusion.
OCCLUSION = {'centroid': 45.5, 'lines': 5.8}
# Table 4.5 [deg]: mean, RMS, standard deviation.
YAW = (0.49, 0.51, 0.11)
# Table 4.6 [mm], width and length: mean, RMS, standard deviation.
SIZE = {'Zivid': {'width': (-0.34, 6.92, 6.98), 'length': (-0.09, 7.92, 8.83)},
        'simulator': {'width': (-1.66, 6.47, 6.25), 'length': (-3.59, 4.68, 2.99)}}
# 4.1.7: largest angle between edges that should be parallel [deg].
LARGEST_EDGE_ANGLE = 2.75
# Table 4.7 [ms], one box: mean, standard deviation.
RUN_TIME = {'Zivid': (134, 15), 'simulator': (73, 11)}

# The same as a row of the detection table, from the column "boxes" on.
DETECTION_ROW = ['', '', '3.10', '3.58', '', '', '0.49', '', '', '4.7–6.5', '', '', '1.00', '', '', '', '', '73']
DETECTION_SOURCE = "The thesis' figures: its tables 4.3, 4.5, 4.6, 4.2 and 4.7, columns of the simulator."
