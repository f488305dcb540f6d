"""What the scan finds, and what it lets pass."""

import unittest

from check_functions import problems_of


class CheckFunctions(unittest.TestCase):
    def names(self, text):
        return [problem.split("'")[1] for _, problem in problems_of(text)]

    def test_functions_of_the_c_library_are_found(self):
        for call in ("std::cos(x)", "sin (x)", "std::atan2(y, x)", "expf(x)", "std::pow(2, x)", "std::hypot(a, b)"):
            self.assertEqual(len(self.names(f"return 2 * {call};")), 1, call)

    def test_reductions_of_eigen_are_found(self):
        for call in ("a.norm()", "(a - b).squaredNorm()", "a.dot(b)", "m.rowwise().mean()", "a.lpNorm<1>()",
                     "a.normalize()", "a->norm()", "x.array().exp()"):
            self.assertEqual(len(self.names(f"return {call};")), 1, call)

    def test_products_of_a_row_and_a_column_are_found(self):
        self.assertEqual(self.names("return a.transpose() * b;"), ["transpose() *"])

    def test_types_that_call_them_are_found(self):
        self.assertEqual(self.names("const Eigen::Rotation2Dd turn(angle);"), ["Rotation2Dd"])

    def test_the_line_is_told(self):
        self.assertEqual([line for line, _ in problems_of("\n\nexp(x);\n")], [3])

    def test_what_is_exact_or_ours_passes(self):
        for text in ("std::sqrt(x)", "cosine(x)", "dot(a, b)", "length_of(a)", "std::fmod(x, 360)", "std::ldexp(1, 3)",
                     "box.expand(x)", "// std::cos(x) and a.norm()", "maxCoeff()", "catalog(x)", "sum_of(x)"):
            self.assertEqual(self.names(text), [], text)


if __name__ == "__main__":
    unittest.main()
