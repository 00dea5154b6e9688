#pragma once

#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "recording/columns/column_words.h"
#include "recording/columns/stated_unit.h"

namespace twrench::recording {

using Words = std::vector<std::string>;
using List = std::initializer_list<std::string_view>;

bool is_in(List list, std::string_view word);
bool has_any(const Words& words, List list);
bool has_only(const Words& words, List list);
Words without(const Words& words, std::size_t first, std::size_t count = 1);

/// The words for the components of a set, in order. A component may have several words.
struct Alphabet {
  std::string_view name;
  std::vector<std::vector<std::string_view>> components;
};

std::optional<std::size_t> component_of(const Alphabet& alphabet, std::string_view word);

/// A group consists of all words except the component's: p in deg/s and p in rad/s are in different
/// groups.
std::string group_of(const Alphabet& alphabet, const Words& words, const std::string& component);

/// The alphabets of the components of a vector.
const std::vector<Alphabet>& vector_axes();

/// The component, if the name is one of these stems and an axis in one word: "rotvecx".
std::optional<std::size_t> joined_component(const Words& words, List stems);

/// Words for the message, the device or the state to which a quantity belongs.
bool is_owner(std::string_view word);

/// The letters of two frames, as in omega_BN: that of the body (B) relative to inertial space (N).
bool is_frame_pair(std::string_view word);

/// Whether the words mean something that is neither a rate nor an attitude: another quantity, or
/// one that is derived from them or that they should follow.
bool are_of_other_quantity(const Words& words);

/// Whether a unit of rates is stated, and it is not that of revolutions.
bool is_rate_in_radians_or_degrees(const StatedUnit& unit);

// The roles of a column with these words, by quantity.
void add_rates(const Words& all_words, std::vector<Role>& roles);
void add_momentum(const Words& all_words, std::vector<Role>& roles);
void add_matrix(const Words& words, std::vector<Role>& roles);
void add_quaternion(const Words& words, std::vector<Role>& roles);
void add_euler(const Words& all_words, std::vector<Role>& roles);
void add_rotation_vector(const Words& all_words, std::vector<Role>& roles);
void add_axis_angle(const Words& all_words, std::vector<Role>& roles);
void add_mrp(const Words& words, std::vector<Role>& roles);
void add_rodrigues(const Words& words, std::vector<Role>& roles);

}  // namespace twrench::recording
