#pragma once

#include <optional>
#include <span>

#include "recording/rows.h"

namespace twrench::check {

/// Returns the longest part of the rows whose rates may be a free motion with noise, of a body
/// whose principal axes are those of the rows: that of a body between the hand and the catch. The
/// ends are accurate to a sixtieth of the rows. Nothing if there is none, or the part is all rows.
///
/// The motion is free if I w + the integral of w x (I w) is constant for some moments I. Their
/// least squares are an eigenvalue problem, and the part is accepted if the residual is that of the
/// scatter from row to row. Judge the part before you rely on it.
std::optional<recording::Extract> free_flight(std::span<const recording::Row> rows);

}  // namespace twrench::check
