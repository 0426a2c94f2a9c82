"""Figures printed in the source thesis, chapter 4.2, and by others for published instances."""

# Table 4.8, of 200 orders each: optimal; better than, equal to, worse than the heuristic alone.
ROBOTIC = {600: (100, 151, 33, 16), 800: (64, 156, 25, 19), 1200: (33, 151, 35, 14)}
# 4.2.3, of 200 orders of 600 mm: orders without unpacked boxes by placement heuristic.
HEURISTICS = {'distance': 50, 'dblf': 100}
# 4.2.4: share of all orders with at most one unpacked box.
AT_MOST_ONE = 0.66
ORDERS = 200
HEIGHTS_MM = (600, 800, 1200)
