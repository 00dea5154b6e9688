"""The published cases: their names, values and errors."""

from __future__ import annotations

import json
import os
import subprocess

import numpy as np
import pytest

import twrench


def test_the_cases_are_those_of_the_program():
    names = twrench.cases()
    assert "basilisk-spacecraft" in names and names == sorted(names)
    for name in names:
        run = subprocess.run(
            [os.environ["TWRENCH_PROGRAM"], "cases", name, "--format", "json"],
            capture_output=True,
            text=True,
            check=True,
        )
        assert twrench.case(name) == json.loads(run.stdout)


def test_the_values_of_a_case_are_those_of_the_exact_motion():
    case = twrench.case("basilisk-spacecraft")
    assert case["inertia"] == [500, 200, 300] and case["inertia_unit"] == "kg m^2"
    last = case["exact"][-1]
    motion = twrench.exact(twrench.Body(moments=case["inertia"]), case["omega"])
    np.testing.assert_array_equal(motion.at([last["t"]]).omega[0], last["omega"])
    (published,) = case["published"]
    np.testing.assert_allclose(published["exact"], published["values"], rtol=0, atol=5e-10)
    assert published["right_to_its_digits"]


def test_a_name_that_no_case_has():
    with pytest.raises(twrench.UsageError, match="did you mean 'gazebo-box'"):
        twrench.case("gazebo-bx")
    with pytest.raises(twrench.UsageError, match="must be a string"):
        twrench.case(3)
