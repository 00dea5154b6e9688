#pragma once

// All of the library's public headers.
#include <twrench/base/error.h>
#include <twrench/body/mass_properties.h>
#include <twrench/body/shape.h>
#include <twrench/body/triangle_mesh.h>
#include <twrench/math/so3.h>
#include <twrench/motion/diagnostics.h>
#include <twrench/motion/error.h>
#include <twrench/motion/exact.h>
#include <twrench/motion/exact_many.h>
#include <twrench/motion/free_body.h>
#include <twrench/motion/method.h>
#include <twrench/motion/polhode.h>
#include <twrench/motion/propagator.h>
#include <twrench/motion/rotating_frame.h>
#include <twrench/motion/stability.h>
#include <twrench/motion/stepper.h>
#include <twrench/motion/trajectory.h>
#include <twrench/study/estimate.h>
#include <twrench/study/flip_search.h>
#include <twrench/study/study.h>
#include <twrench/version.h>
