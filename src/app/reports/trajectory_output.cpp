#include "app/reports/trajectory_output.h"

#include <fmt/format.h>
#include <twrench/base/error.h>
#include <twrench/motion/diagnostics.h>
#include <twrench/motion/trajectory.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/parallel.h"
#include "scene/limits.h"
#include "scene/natural_times.h"

namespace twrench::app {
namespace {

/// The text before, between and after the samples, and that of a sample.
struct TextFormat {
  std::string before, between, after;
  std::function<std::string(const motion::Sample&, const motion::Diagnostics&)> row;
};

/// Appends a number with 17 significant digits, as "{:.17g}" does, in half of the time.
void append_number(std::string& text, double value) {
  std::array<char, 32> digits;
  const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value,
                                          std::chars_format::general, 17);
  text.append(digits.data(), end);
}

std::string csv_row(const motion::Sample& s, const motion::Diagnostics& d) {
  std::string text;
  text.reserve(512);
  append_number(text, s.t);
  const auto append = [&](double value) {
    text += ',';
    append_number(text, value);
  };
  for (int i = 0; i < 9; ++i) append(s.X(i / 3, i % 3));
  for (const double w : s.omega) append(w);
  for (const double value : {d.energy, d.energy_drift, d.orthogonality_error, d.momentum_error}) {
    append(value);
  }
  text += '\n';
  return text;
}

TextFormat csv_format() {
  return {
      "t,x11,x12,x13,x21,x22,x23,x31,x32,x33,wx,wy,wz,"
      "energy,energy_drift,orthogonality_error,momentum_error\n",
      "", "", csv_row};
}

/// Indented to its depth in the document.
std::string json_row(const motion::Sample& s, const motion::Diagnostics& d) {
  const auto X = s.X.reshaped<Eigen::RowMajor>();
  const nlohmann::ordered_json row{{"t", s.t},
                                   {"X", std::vector<double>(X.begin(), X.end())},
                                   {"omega", std::vector<double>(s.omega.begin(), s.omega.end())},
                                   {"energy", d.energy},
                                   {"energy_drift", d.energy_drift},
                                   {"orthogonality_error", d.orthogonality_error},
                                   {"momentum_error", d.momentum_error}};
  std::string text;
  for (const char c : row.dump(1)) {
    text += c;
    if (c == '\n') text += "  ";
  }
  return text;
}

TextFormat json_format(const scene::Scene& scene) {
  const nlohmann::ordered_json document{{"scene", scene.name},
                                        {"method", scene.motion.method},
                                        {"samples", nlohmann::ordered_json::array()}};
  const std::string text =
      document.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  const std::size_t samples = text.rfind(']');
  return {text.substr(0, samples) + "\n  ", ",\n  ", "\n " + text.substr(samples) + "\n", json_row};
}

/// Writes samples in blocks whose rows several threads turn into text: that is most of the work for
/// the closed form.
class RowWriter {
 public:
  RowWriter(Output& output, TextFormat text, const motion::FreeBody& body)
      : output_(output),
        text_(std::move(text)),
        body_(body),
        start_(motion::energy(body.inertia(), body.omega())) {
    output_.write(text_.before);
  }

  void add(const motion::Sample& sample) {
    block_.push_back(sample);
    if (block_.size() == block_size) write_block();
  }

  void finish() {
    write_block();
    output_.write(text_.after);
  }

 private:
  static constexpr std::size_t block_size = 8192, grain = 512;

  void write_block() {
    std::array<std::string, block_size / grain> texts;
    for_each_part(block_.size(), grain, 0, [&](std::size_t begin, std::size_t end) {
      std::string& text = texts[begin / grain];
      for (std::size_t i = begin; i < end; ++i) {
        if (i > 0 || !is_first_) text += text_.between;
        text += text_.row(block_[i], motion::diagnose(body_, start_, block_[i]));
      }
    });
    for (const std::string& text : texts) output_.write(text);
    is_first_ = is_first_ && block_.empty();
    block_.clear();
  }

  Output& output_;
  TextFormat text_;
  const motion::FreeBody& body_;
  double start_;  ///< Energy at t = 0, g cm^2/s^2.
  std::vector<motion::Sample> block_;
  bool is_first_ = true;  ///< Nothing has been written yet.
};

/// Names --fps only if its limit allows the rate.
std::string remedy_for_samples(double duration) {
  const double rate = 0.9 * scene::limits::max_frames / duration;  // leaves room for rounding
  if (rate > scene::limits::fps.high) return "use a shorter --duration";
  return fmt::format("use --fps {:.4g} or less, or a shorter --duration",
                     std::max(rate, scene::limits::fps.low));
}

}  // namespace

RegularTimes::RegularTimes(const scene::Scene& scene)
    : duration_(scene.motion.duration), rate_(scene::sample_rate(scene)) {
  const double samples = duration_ * rate_, whole = std::floor(samples);
  if (whole > scene::limits::max_frames) {
    throw InvalidArgument(
        "samples",
        fmt::format("there would be {:.7g}, {} a second for {} s, but at most {} are allowed",
                    whole, rate_, duration_, scene::limits::max_frames),
        remedy_for_samples(duration_));
  }
  constexpr double rounding = 1e-12;  // else the last two times might differ by it
  size_ = static_cast<std::size_t>(std::ceil(samples * (1 - rounding))) + 1;
}

void write_trajectory(Output& output, const scene::Scene& scene, const std::string& format,
                      const std::vector<double>& times) {
  const motion::Method& method = motion::find_method(scene.motion.method);
  const motion::FreeBody body(scene::mass_properties(scene.body).inertia, scene.motion.omega);
  RowWriter rows(output, format == "csv" ? csv_format() : json_format(scene), body);
  if (times.empty()) {
    const RegularTimes regular(scene);
    motion::visit_samples(body, method, scene.motion.control, regular.size(), regular,
                          [&](const motion::Sample& sample) { rows.add(sample); });
  } else {
    for (const motion::Sample& sample :
         motion::integrate(body, method, scene.motion.control, times).samples) {
      rows.add(sample);
    }
  }
  rows.finish();
}

}  // namespace twrench::app
