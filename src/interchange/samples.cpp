#include "interchange/samples.h"

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
#include "base/words.h"
#include "interchange/npz.h"
#include "motion/visible_error.h"
#include "scene/limits.h"
#include "scene/natural_times.h"
#include "scene/shown_recording.h"

namespace twrench::interchange {
namespace {

/// A diagnostic with the name of its column.
struct Column {
  const char* name;
  double motion::Diagnostics::*value;
};

/// The diagnostics that have a meaning for the body: the drift of an energy that the body loses is
/// no error.
std::vector<Column> columns_of(const motion::FreeBody& body) {
  using motion::Diagnostics;
  std::vector<Column> columns{{"energy", &Diagnostics::energy}};
  if (!std::isfinite(body.interior().energy_loss_time)) {
    columns.push_back({"energy_drift", &Diagnostics::energy_drift});
  }
  columns.push_back({"orthogonality_error", &Diagnostics::orthogonality_error});
  columns.push_back({"momentum_error", &Diagnostics::momentum_error});
  return columns;
}

/// The text before, between and after the samples, and the text of each sample.
struct TextFormat {
  std::string before, between;
  std::function<std::string(const std::string& note)> after;
  std::function<std::string(const motion::Sample&, const motion::Diagnostics&)> row;
};

/// Appends the fewest digits that read back as the same number, as "{}" does, in less time.
void append_number(std::string& text, double value) {
  std::array<char, 32> digits;
  const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  text.append(digits.data(), end);
}

std::string csv_row(const std::vector<Column>& columns, const motion::Sample& s,
                    const motion::Diagnostics& d) {
  std::string text;
  text.reserve(512);
  append_number(text, s.t);
  const auto append = [&](double value) {
    text += ',';
    append_number(text, value);
  };
  for (int i = 0; i < 9; ++i) append(s.X(i / 3, i % 3));
  for (const double w : s.omega) append(w);
  for (const Column& column : columns) append(d.*column.value);
  text += '\n';
  return text;
}

/// The same for a scene; of a recording whose body is not known, only what needs no body.
std::vector<Column> columns_of(const scene::Scene& scene, const motion::FreeBody& body) {
  const auto& recording = scene.motion.recording;
  if (!recording || recording->has_body) return columns_of(body);
  return {{"orthogonality_error", &motion::Diagnostics::orthogonality_error}};
}

TextFormat csv_format(const std::vector<Column>& columns) {
  std::string header = "t,x11,x12,x13,x21,x22,x23,x31,x32,x33,wx,wy,wz";
  for (const Column& column : columns) header += std::string(",") + column.name;
  return {header + "\n", "", [](const std::string&) { return std::string(); },
          [columns](const motion::Sample& s, const motion::Diagnostics& d) {
            return csv_row(columns, s, d);
          }};
}

/// A row, indented to its depth in the document.
std::string json_row(const std::vector<Column>& columns, const motion::Sample& s,
                     const motion::Diagnostics& d) {
  const auto X = s.X.reshaped<Eigen::RowMajor>();
  nlohmann::ordered_json row{{"t", s.t},
                             {"X", std::vector<double>(X.begin(), X.end())},
                             {"omega", std::vector<double>(s.omega.begin(), s.omega.end())}};
  for (const Column& column : columns) row[column.name] = d.*column.value;
  std::string text;
  for (const char c : row.dump(1)) {
    text += c;
    if (c == '\n') text += "  ";
  }
  return text;
}

TextFormat json_format(const scene::Scene& scene, const std::vector<Column>& columns) {
  const nlohmann::ordered_json document{
      {"scene", scene.name},
      {"method", scene.motion.recording ? std::string(scene::recorded_name) : scene.motion.method},
      {"samples", nlohmann::ordered_json::array()}};
  const std::string text =
      document.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  const std::size_t samples = text.rfind(']');
  return {text.substr(0, samples) + "\n  ", ",\n  ",
          [end = text.substr(samples + 1)](const std::string& note) {
            const nlohmann::json quoted = note;
            return "\n ]" + (note.empty() ? "" : ",\n \"note\": " + quoted.dump()) + end + "\n";
          },
          [columns](const motion::Sample& s, const motion::Diagnostics& d) {
            return json_row(columns, s, d);
          }};
}

/// Writes samples in blocks. Several threads convert the rows of a block to text, because that is
/// most of the work for the closed form.
class RowWriter {
 public:
  RowWriter(const Write& write, TextFormat text, const motion::FreeBody& body)
      : write_(write),
        text_(std::move(text)),
        body_(body),
        start_(motion::energy(body.inertia(), body.omega())) {
    write_(text_.before);
  }

  void add(const motion::Sample& sample) {
    // Adding 0 changes only -0, which would look odd.
    block_.push_back({sample.t, sample.X.array() + 0.0, sample.omega.array() + 0.0});
    if (block_.size() == block_size) write_block();
  }

  void finish(const std::string& note) {
    write_block();
    write_(text_.after(note));
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
    for (const std::string& text : texts) write_(text);
    is_first_ = is_first_ && block_.empty();
    block_.clear();
  }

  const Write& write_;
  TextFormat text_;
  const motion::FreeBody& body_;
  double start_;  ///< Energy at t = 0, g cm^2/s^2.
  std::vector<motion::Sample> block_;
  bool is_first_ = true;  ///< Whether nothing has been written yet.
};

/// Collects samples as the arrays of a .npz file, which has one array after the other.
class ArrayWriter {
 public:
  ArrayWriter(const Write& write, const std::vector<Column>& columns, const motion::FreeBody& body)
      : write_(write),
        columns_(columns),
        body_(body),
        start_(motion::energy(body.inertia(), body.omega())) {
    for (const Column& column : columns) arrays_.push_back({column.name});
  }

  void add(const motion::Sample& sample) {
    const auto X = sample.X.reshaped<Eigen::RowMajor>();
    arrays_[0].numbers.push_back(sample.t);
    arrays_[1].numbers.insert(arrays_[1].numbers.end(), X.begin(), X.end());
    arrays_[2].numbers.insert(arrays_[2].numbers.end(), sample.omega.begin(), sample.omega.end());
    const motion::Diagnostics diagnostics = motion::diagnose(body_, start_, sample);
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      arrays_[3 + i].numbers.push_back(diagnostics.*columns_[i].value);
    }
  }

  void finish(const std::string& /*note*/) { write_(npz_file(arrays_)); }

 private:
  const Write& write_;
  const std::vector<Column>& columns_;
  const motion::FreeBody& body_;
  double start_;  ///< Energy at t = 0, g cm^2/s^2.
  std::vector<NamedArray> arrays_{{"t"}, {"X", {3, 3}}, {"omega", {3}}};
};

/// Suggests a rate only if its limit allows the rate.
std::string remedy_for_samples(double duration) {
  const double rate = 0.9 * scene::limits::max_frames / duration;  // leaves room for rounding
  if (rate > scene::limits::fps.high) return "use a shorter " + argument("duration");
  const std::string fps = fmt::format("{:.4g}", std::max(rate, scene::limits::fps.low));
  return fmt::format("use {} or less, or a shorter {}", argument("fps", fps), argument("duration"));
}

template <typename Rows>
void write_recorded(Rows& rows, const scene::Scene& scene, std::span<const double> times) {
  const motion::RecordedMotion& recorded = scene.motion.recording->motion;
  for (const double t : times) {
    constexpr double rounding = 1 + 1e-12;
    if (t < 0 || t > rounding * recorded.duration()) {
      throw InvalidArgument(scene.motion.recording->file,
                            fmt::format("{:.9g} s is not among the {:.9g} s that are recorded", t,
                                        recorded.duration()));
    }
    rows.add(recorded.at(t));
  }
}

/// Writes the samples to rows of either kind. Returns a note, as write_trajectory() does.
template <typename Rows>
std::string write_samples(Rows rows, const scene::Scene& scene, const motion::FreeBody& body,
                          const std::vector<double>& times, const Progress& progress) {
  if (scene.motion.recording) {
    std::vector<double> all = times;
    const RegularTimes regular(scene);
    for (std::size_t i = 0; times.empty() && i < regular.size(); ++i) all.push_back(regular(i));
    write_recorded(rows, scene, all);
    rows.finish({});
    return {};
  }
  const motion::Method& method = motion::find_method(scene.motion.method);
  motion::Sample latest{0, Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero()};
  const auto add = [&](const motion::Sample& sample) {
    if (std::abs(sample.t) >= std::abs(latest.t)) latest = sample;
    rows.add(sample);
  };
  if (times.empty()) {
    const RegularTimes regular(scene);
    std::size_t done = 0;
    motion::visit_samples(body, method, scene.motion.control, regular.size(), regular,
                          [&](const motion::Sample& sample) {
                            add(sample);
                            if (progress && !method.exact()) progress(++done, regular.size());
                          });
  } else {
    for (const motion::Sample& sample :
         motion::integrate(body, method, scene.motion.control, times).samples) {
      add(sample);
    }
  }
  std::string note = motion::visible_error(body, method, latest);
  rows.finish(note);
  return note;
}

}  // namespace

RegularTimes::RegularTimes(const scene::Scene& scene)
    : duration_(scene.motion.duration), rate_(scene::sample_rate(scene)) {
  const double samples = duration_ * rate_, whole = std::floor(samples);
  if (whole > scene::limits::max_frames) {
    throw InvalidArgument(
        "samples",
        fmt::format("{:.7g} samples requested ({} per second for {} s); the limit is {}", whole,
                    rate_, duration_, scene::limits::max_frames),
        remedy_for_samples(duration_));
  }
  constexpr double rounding = 1e-12;  // otherwise the last two times might differ only by it
  size_ = static_cast<std::size_t>(std::ceil(samples * (1 - rounding))) + 1;
}

std::string write_trajectory(const Write& write, const scene::Scene& scene,
                             const std::string& format, const std::vector<double>& times,
                             const Progress& progress) {
  const motion::FreeBody body = scene::free_body(scene);
  const std::vector<Column> columns = columns_of(scene, body);
  if (format == "npz") {
    return write_samples(ArrayWriter(write, columns, body), scene, body, times, progress);
  }
  TextFormat text = format == "csv" ? csv_format(columns) : json_format(scene, columns);
  return write_samples(RowWriter(write, std::move(text), body), scene, body, times, progress);
}

void write_csv(const Write& write, const motion::FreeBody& body,
               std::span<const motion::Sample> samples) {
  RowWriter rows(write, csv_format(columns_of(body)), body);
  for (const motion::Sample& sample : samples) rows.add(sample);
  rows.finish({});
}

}  // namespace twrench::interchange
