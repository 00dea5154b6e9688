#pragma once

#include <optional>
#include <span>
#include <vector>

#include "check/hypotheses/readings.h"
#include "check/law/mistakes.h"
#include "check/verdict/judge.h"
#include "check/verdict/problem.h"
#include "recording/recording.h"

namespace twrench::check {

/// Rows to which laws are fitted, and their noise.
struct LawRows {
  std::vector<recording::Row> rows;
  RelativeNoise noise;
};

/// Rows in a convention that are spread over the whole file, with the rates of the attitude if
/// there are no others.
LawRows law_rows(const recording::Recording& recording, const Problem& problem,
                 const recording::Convention& convention, const Judgement& judgement);

RowParts parts_of(const Judgement& judgement);

/// The wrong laws that the rows follow as they are read.
WrongLaws laws_of(const recording::Recording& recording, const Problem& problem,
                  const Judgement& judgement);

/// The part of the changes in rates and attitude that even the best law misses.
LawMiss miss_of(const WrongLaws& laws);

/// A reading, and how well a law or the kinematics explains it.
struct Lawful {
  Reading reading;
  double miss;       ///< the worst of miss_of()
  int free_numbers;  ///< of the law
};

/// Returns the part of the changes that the motion of a free body misses. Throws as judge() does.
double miss_of_free_body(const recording::Recording& recording, const Problem& problem,
                         const recording::Convention& convention);

/// Returns the reading in which a wrong law explains the rows, or their attitude integrates their
/// rates, if all others explain far less or with more fitted numbers; otherwise nothing.
std::optional<Lawful> only_lawful(const recording::Recording& recording, const Problem& problem,
                                  std::span<const recording::Convention> conventions);

}  // namespace twrench::check
