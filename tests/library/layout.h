#pragma once

#include <twrench/body/mass_properties.h>
#include <twrench/motion/exact.h>
#include <twrench/motion/polhode.h>
#include <twrench/motion/propagator.h>
#include <twrench/motion/rotating_frame.h>
#include <twrench/motion/stability.h>
#include <twrench/motion/stepper.h>

// The layout of the public types that contain Eigen types. The library and every program that links
// it must agree on the layout, whatever their compiler flags.

namespace twrench {

/// Returns whether a type has the size of `count` doubles and their alignment.
template <class Type>
constexpr bool has_doubles(std::size_t count) {
  return sizeof(Type) == count * sizeof(double) && alignof(Type) == alignof(double);
}

static_assert(has_doubles<body::SolidIntegrals>(1 + 3 + 9));
static_assert(has_doubles<body::MassProperties>(1 + 3 + 9 + 3 + 9));
static_assert(has_doubles<body::PrincipalAxes>(3 + 9));
static_assert(has_doubles<body::PointMass>(1 + 3));
static_assert(has_doubles<body::Box>(3));
static_assert(has_doubles<body::Ellipsoid>(3));
static_assert(alignof(body::Part) == alignof(double));
static_assert(has_doubles<motion::Interior>(3 + 1));
static_assert(has_doubles<motion::FreeBody>(9 + (3 + 9) + 9 + 3 + 9 + 3 + 3 + (3 + 1) + 1 + 1));
static_assert(has_doubles<motion::Sample>(1 + 9 + 3));
static_assert(has_doubles<motion::Step>(9 + 1 + 1));
static_assert(has_doubles<motion::AcceptedStep>(2 + 9 + 9 + 1));
static_assert(has_doubles<motion::EnergyLevel>(3 + 1 + 1 + 1));
static_assert(has_doubles<motion::RotatingFrame>(9 + 3 + 3));
static_assert(has_doubles<motion::PointForces>(7 * 3));
static_assert(has_doubles<motion::FrameForces>(9 + (9 + 3 + 3) + 3 + 3));
static_assert(has_doubles<motion::Tilt>(3 + 9 + 9 + 3 + 1 + 3 + 1 + 1));

}  // namespace twrench
