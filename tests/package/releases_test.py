#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What the check of a board's package refuses, by tools/package/releases.py. Its argument is that folder."""

import sys

sys.path.insert(0, sys.argv.pop(1))

import unittest  # noqa: E402

from releases import depends_faults, newest, symbol_faults  # noqa: E402


class Depends(unittest.TestCase):
    def test_what_both_releases_have(self) -> None:
        self.assertEqual(depends_faults("libc6 (>= 2.35), libstdc++6 (>= 12), systemd (>= 249), udev"), [])
        self.assertEqual(depends_faults(""), [])

    def test_a_version_that_the_older_lacks(self) -> None:
        (fault,) = depends_faults("udev, libc6 (>= 2.36)")
        self.assertEqual(fault, "depends on libc6 (>= 2.36); the two releases have 2.35-0ubuntu3 and 2.36-9")

    def test_a_package_of_one_release(self) -> None:
        (fault,) = depends_faults("libc6 (>= 2.35), libfmt9 (>= 9.1.0+ds1)")
        self.assertIn("libfmt9", fault)

    def test_forms_that_are_not_understood(self) -> None:
        for depends in ("libc6 (= 2.35)", "libc6 | libc6.1", "libc6 (>> 2.0)"):
            self.assertEqual(len(depends_faults(depends)), 1, depends)


class Symbols(unittest.TestCase):
    def test_what_both_releases_have(self) -> None:
        self.assertEqual(symbol_faults(["GLIBC_2.4", "GLIBC_2.35", "GLIBCXX_3.4.30", "CXXABI_1.3.13"]), [])

    def test_newer_ones_by_number_not_by_letter(self) -> None:
        self.assertEqual(symbol_faults(["GLIBC_2.4"]), [])
        (fault,) = symbol_faults(["GLIBC_2.36", "GLIBC_2.36"])
        self.assertEqual(fault, "needs symbols of GLIBC_2.36; the older release has GLIBC_2.35")
        self.assertEqual(len(symbol_faults(["GLIBCXX_3.4.32", "CXXABI_1.3.14"])), 2)

    def test_what_is_not_known(self) -> None:
        for version in ("GLIBC_ABI_DT_RELR", "GLIBC_PRIVATE", "LIBOTHER_1.0"):
            self.assertEqual(len(symbol_faults([version])), 1, version)

    def test_the_newest_are_named(self) -> None:
        self.assertEqual(newest(["GLIBC_2.4", "GLIBC_2.34", "GCC_3.5"]), "GCC_3.5, GLIBC_2.34")


unittest.main()
