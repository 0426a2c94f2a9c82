"""Figures printed in the source thesis, chapter 4.2, and by others for published instances."""

# Table 4.8, of 200 orders each: optimal; better than, equal to, worse than the heuristic alone.
ROBOTIC = {600: (100, 151, 33, 16), 800: (64, 156, 25, 19), 1200: (33, 151, 35, 14)}
# Read from the histograms: mean of unpacked boxes of Fig. 4.22 and 4.28, orders without any of Fig. 4.24.
HEURISTIC_LEFT = {600: 2.24, 800: 3.13, 1200: 5.37}
ROBOTIC_LEFT = {600: 0.75, 800: 1.14, 1200: 2.36}
SEARCH_PERFECT = {600: 0.92, 800: 0.88, 1200: 0.92}
ORDERS = 200
HEIGHTS_MM = (600, 800, 1200)
# Fig. 4.26 and the text below it, 600 mm: orders of 200 that the choice by future costs packs perfectly, by placement rule.
PERFECT_BY_RULE = {'distance': 50, 'dblf': 100}
