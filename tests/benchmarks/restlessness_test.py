"""The distance of particles from their smooth paths, by hand."""

import unittest

import numpy as np

from restlessness import restlessness_mm


def one_particle(along_x):
    positions = np.zeros((len(along_x), 1, 1, 3))
    positions[:, 0, 0, 0] = along_x
    return positions


class Restlessness(unittest.TestCase):
    def test_an_even_acceleration_is_smooth(self):
        time = np.arange(20.0)
        distances = restlessness_mm(one_particle(3 + 2 * time - 0.5 * time**2))
        self.assertEqual(distances.shape, (12, 1, 1))
        self.assertLess(distances.max(), 1e-9)

    def test_a_jump_of_one_frame_counts_but_for_what_bends_the_path(self):
        still = np.zeros(17)
        still[8] = 0.001
        distances = restlessness_mm(one_particle(still))[:, 0, 0]
        self.assertAlmostEqual(distances[4], 1 - 59 / 231)
        self.assertAlmostEqual(distances[0], 21 / 231)

    def test_half_the_speed_over_every_other_frame_is_the_same_way(self):
        time = np.arange(40.0)
        slow = one_particle(np.sin(time / 7))
        distances = restlessness_mm(slow, every=2)
        np.testing.assert_array_equal(distances[::2], restlessness_mm(slow[::2]))
        self.assertGreater(distances.max(), restlessness_mm(slow).max())


if __name__ == "__main__":
    unittest.main()
